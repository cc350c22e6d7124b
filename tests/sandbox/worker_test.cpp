// What a worker does for a grader: the same pictures as without it, and nothing left between two
// jobs.
#include "lab/worker.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "core/version.h"
#include "honest.h"

namespace shadowlab::lab {
namespace {

namespace fs = std::filesystem;

using sandbox_tests::isolation;

class WorkerTest : public sandbox_tests::InFolder {};

Job job_of(const fs::path& recipe, int size = 64) {
  Job job{.recipe = recipe, .width = size, .height = size};
  for (const char* light : {"2,4,1", "0,4,0", "-1,3,2"})
    job.shots.push_back({.settings = {{"light", light}}});
  return job;
}

std::vector<Drawing> drawn_here(const Job& job) {
  gl::Graphics graphics(context::create(), job.width, job.height);
  std::vector<Drawing> drawings;
  draw(graphics, job,
       [&](std::size_t, Drawing drawing) { drawings.push_back(std::move(drawing)); });
  return drawings;
}

void expect_same(const std::vector<Drawing>& a, const std::vector<Drawing>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].error, b[i].error);
    EXPECT_TRUE(a[i].frame.color == b[i].frame.color) << "shot " << i;
    EXPECT_TRUE(a[i].frame.depth.values == b[i].frame.depth.values) << "shot " << i;
    EXPECT_EQ(a[i].frame.depth.width, b[i].frame.depth.width);
    EXPECT_TRUE(a[i].frame.stencil == b[i].frame.stencil) << "shot " << i;
    ASSERT_EQ(a[i].passes.size(), b[i].passes.size());
    for (std::size_t k = 0; k < a[i].passes.size(); ++k) {
      EXPECT_EQ(a[i].passes[k].pass, b[i].passes[k].pass);
      EXPECT_TRUE(a[i].passes[k].color == b[i].passes[k].color);
      EXPECT_TRUE(a[i].passes[k].stencil == b[i].passes[k].stencil);
    }
    ASSERT_EQ(a[i].calls.size(), b[i].calls.size());
    for (std::size_t k = 0; k < a[i].calls.size(); ++k) {
      EXPECT_EQ(a[i].calls[k].function, b[i].calls[k].function);
      EXPECT_EQ(a[i].calls[k].arguments, b[i].calls[k].arguments);
      EXPECT_EQ(a[i].calls[k].pass, b[i].calls[k].pass);
    }
    EXPECT_EQ(a[i].printed, b[i].printed);
  }
}

TEST_F(WorkerTest, draws_the_pictures_passes_and_calls_that_are_drawn_here) {
  Job job = job_of(home() / "scripts" / "projected_stencil.lua");
  job.passes = everything;
  job.calls = true;
  Worker worker(isolation());
  const Outcome outcome = worker.draw(job);
  EXPECT_EQ(outcome.verdict, Verdict::finished) << outcome.sentence;
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err, "");
  expect_same(outcome.drawings, drawn_here(job));
}

TEST_F(WorkerTest, draws_the_same_whatever_it_was_warmed_with_and_of_whatever_size_it_is) {
  const Job job = job_of(home() / "scripts" / "volumes_zfail.lua");
  const auto here = drawn_here(job);
  lab::Isolation warm = isolation();
  warm.width = warm.height = 64;
  warm.warm = {home() / "scripts" / "banding.lua", home() / "scripts" / "volumes_zfail.lua",
               home() / "scripts" / "fbo_draw_buffers.lua"};
  Worker worker(warm);
  expect_same(worker.draw(job).drawings, here);
  expect_same(worker.draw(job).drawings, here);
  expect_same(Worker(isolation()).draw(job).drawings, here);
}

TEST_F(WorkerTest, hands_each_drawing_over_in_its_order) {
  Worker worker(isolation());
  std::vector<std::size_t> shots;
  const Outcome outcome = worker.draw(honest(), [&](std::size_t shot, const Drawing& drawing) {
    shots.push_back(shot);
    EXPECT_FALSE(drawing.error);
  });
  EXPECT_EQ(shots, (std::vector<std::size_t>{0, 1}));
  EXPECT_TRUE(outcome.drawings.empty());
}

TEST_F(WorkerTest, keeps_what_was_drawn_before_the_time_was_over) {
  lab::Isolation brief = isolation();
  brief.seconds = 1.5;
  Job job = job_of(write("slow.lua", R"(
    return { params = { light = param.point(0, 0, 0) }, draw = function(r)
      gl.Clear(gl.COLOR_BUFFER_BIT)
      while r.params.light.x == 0 do end
    end })"));
  Worker worker(brief);
  const Outcome outcome = worker.draw(job);
  EXPECT_EQ(outcome.verdict, Verdict::timed_out);
  EXPECT_NE(outcome.sentence.find("1.5 s"), std::string::npos) << outcome.sentence;
  EXPECT_EQ(outcome.drawings.size(), 1u);
}

// The process that `process` started, 0 while there is none.
pid_t child_of(pid_t process) {
  pid_t child = 0;
  std::ifstream(fmt::format("/proc/{0}/task/{0}/children", process)) >> child;
  return child;
}

// Seconds of processor time after which the kernel ends it; 0 while nothing would.
double processor_limit_of(pid_t process) {
  std::ifstream limits(fmt::format("/proc/{}/limits", process));
  const std::string mark = "Max cpu time";
  for (std::string line; std::getline(limits, line);)
    if (line.starts_with(mark)) return std::atof(line.c_str() + mark.size());
  return 0;
}

// The kernel's limit ends a job by the signal of a lack of memory, and a loop has as much processor
// time as time on the wall but for what its machine rounds.
TEST_F(WorkerTest, the_clock_that_says_why_is_over_before_the_kernels) {
  lab::Isolation brief = isolation();
  brief.seconds = 1;
  brief.namespaces = lab::Isolation::Namespaces::none;
  Worker worker(brief);
  const pid_t zygote = child_of(::getpid());
  if (zygote == 0) GTEST_SKIP() << "this kernel does not say whose child a process is";
  Job job = job_of(write("loop.lua", "while true do end"));
  Outcome outcome;
  std::atomic<bool> over = false;
  std::jthread drawing([&] {
    outcome = worker.draw(job);
    over = true;
  });
  double limit = 0;
  while (limit == 0 && !over) limit = processor_limit_of(child_of(zygote));
  drawing.join();
  EXPECT_EQ(outcome.verdict, Verdict::timed_out) << outcome.sentence;
  EXPECT_GE(limit, brief.seconds + 1);
}

TEST_F(WorkerTest, serves_any_number_of_threads_at_once) {
  Worker worker(isolation());
  const Job mine = honest();
  std::vector<Outcome> outcomes(12);
  {
    std::vector<std::jthread> threads;
    for (int i = 0; i < 4; ++i) {
      threads.emplace_back([&, i] {
        for (std::size_t k = static_cast<std::size_t>(i); k < outcomes.size(); k += 4)
          outcomes[k] = worker.draw(mine);
      });
    }
  }
  for (const Outcome& outcome : outcomes) expect_honest(outcome);
}

TEST_F(WorkerTest, holds_without_namespaces_by_its_other_layers) {
  lab::Isolation bare = isolation();
  bare.namespaces = lab::Isolation::Namespaces::none;
  Worker worker(bare);
  EXPECT_FALSE(worker.layers().namespaces);
  EXPECT_TRUE(worker.layers().filter);
  const Outcome outcome = worker.draw(honest());
  expect_honest(outcome);
  EXPECT_EQ(outcome.layers, worker.layers());
}

TEST_F(WorkerTest, does_not_follow_a_link_that_was_handed_in) {
  fs::create_symlink("/etc/passwd", folder / "link.lua");
  fs::create_directory(folder / "folder.lua");
  Worker worker(isolation());
  for (const auto& [name, part] : {std::pair{"link.lua", "is a link"},
                                   {"folder.lua", "not a plain file"},
                                   {"none.lua", "cannot be read"}}) {
    const Outcome outcome = worker.draw(job_of(folder / name));
    EXPECT_EQ(outcome.verdict, Verdict::recipe_error);
    EXPECT_NE(outcome.sentence.find(part), std::string::npos) << outcome.sentence;
    EXPECT_EQ(outcome.sentence.find("root:"), std::string::npos);
  }
}

TEST_F(WorkerTest, shows_a_submission_its_own_file_and_no_neighbour) {
  write("solution.lua", "return { secret = 'the answer' }");
  write("secret.vert", "void main() {}");
  write("secret.frag", "void main() {}");
  Worker worker(isolation());
  for (const char* body : {"require 'solution'", "shader.load 'secret'"}) {
    const Outcome outcome = worker.draw(
        job_of(write("curious.lua", fmt::format("return {{ draw = function() {} end }}", body))));
    EXPECT_EQ(outcome.verdict, Verdict::recipe_error) << body;
    EXPECT_EQ(outcome.sentence.find("the answer"), std::string::npos);
  }
}

TEST_F(WorkerTest, leaves_no_file_behind) {
  const auto shadowlab_folders = [] {
    int count = 0;
    for (const auto& entry : fs::directory_iterator(fs::temp_directory_path()))
      count += entry.path().filename().string().starts_with("shadowlab-");
    return count;
  };
  setenv("TMPDIR", folder.c_str(), 1);
  {
    Worker worker(isolation());
    expect_honest(worker.draw(honest()));
    EXPECT_EQ(shadowlab_folders(), 1);
  }
  EXPECT_EQ(shadowlab_folders(), 0);
  unsetenv("TMPDIR");
}

TEST_F(WorkerTest, says_plainly_where_no_worker_can_be) {
  lab::Isolation without = isolation();
  without.program = folder / "nothing";
  EXPECT_THROW(Worker{without}, MachineError);
}

}  // namespace
}  // namespace shadowlab::lab
