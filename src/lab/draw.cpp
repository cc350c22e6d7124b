#include <fmt/format.h>

#include <algorithm>
#include <new>

#include "core/clock.h"
#include "core/error.h"
#include "gl/recorder.h"
#include "gl/replay.h"
#include "lab/job.h"
#include "recipe/recipe.h"

namespace shadowlab::lab {
namespace {

Buffers read(const gl::MainFrame& frame, const Kept& kept, std::string pass) {
  Buffers buffers;
  buffers.pass = std::move(pass);
  if (kept.color) buffers.color = frame.read_color();
  if (kept.depth) buffers.depth = frame.read_depth();
  if (kept.stencil) buffers.stencil = frame.read_stencil();
  return buffers;
}

// The calls of the frame that `recorder` holds, as C writes them.
std::vector<Call> calls_of(const gl::Recorder& recorder) {
  std::vector<Call> calls;
  const std::size_t count = std::min(recorder.size(), most_calls);
  calls.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    gl::TracedCall call = recorder.call(i);
    calls.push_back({std::string(call.function), std::move(call.arguments), call.pass,
                     std::move(call.comment)});
  }
  return calls;
}

// Traces what `graphics` is asked for, while it lives, and puts the changes in their places.
class Traced : private gl::DrawObserver {
 public:
  Traced(gl::Graphics& graphics, gl::Recorder& recorder, std::span<const Change> changes)
      : graphics_(graphics), recorder_(recorder), changes_(changes) {
    graphics_.trace_into(&recorder_);
    if (!changes.empty()) graphics_.calls().draws = this;
  }
  ~Traced() override {
    graphics_.trace_into(nullptr);
    graphics_.calls().draws = nullptr;
  }
  Traced(const Traced&) = delete;
  Traced& operator=(const Traced&) = delete;

 private:
  void before_draw(const std::function<void()>&) override {
    if (!graphics_.recorder()) return;  // the core's own, in no trace
    for (; !changes_.empty() && changes_.front().call <= recorder_.size();
         changes_ = changes_.subspan(1))
      gl::replay(graphics_.gl, changes_.front().function, changes_.front().arguments);
  }

  gl::Graphics& graphics_;
  gl::Recorder& recorder_;
  std::span<const Change> changes_;
};

recipe::Options options_of(const Job& job, const Shot& shot, std::string& printed) {
  recipe::Options options;
  options.limits = job.limits;
  options.scene = shot.scene;
  options.print = [&printed](std::string_view text) { printed += text; };
  return options;
}

// A recipe anew for each shot: nothing that a script keeps reaches the next one.
void draw_into(Drawing& drawing, gl::Graphics& graphics, const Job& job, const Shot& shot) {
  recipe::Recipe recipe(graphics, job.recipe, options_of(job, shot, drawing.printed));
  for (const auto& [name, value] : shot.settings) recipe.set(name, value);
  if (shot.camera) recipe.set_camera(*shot.camera);
  gl::Recorder recorder;
  std::optional<Traced> traced;
  if (job.calls || !shot.changes.empty()) traced.emplace(graphics, recorder, shot.changes);
  if (job.passes.any()) {
    recipe.on_pass_end([&](std::size_t pass) {
      if (drawing.passes.size() < most_passes)
        drawing.passes.push_back(read(graphics.frame, job.passes, recipe.passes()[pass].name));
    });
  }
  try {
    recipe.draw();
  } catch (const InputError& problem) {
    drawing.error = problem.what();
  }
  if (job.calls) drawing.calls = calls_of(recorder);
  drawing.frame = read(graphics.frame, job.frame, "");
}

Drawing drawn(gl::Graphics& graphics, const Job& job, const Shot& shot) {
  const double began = now_ms();
  Drawing drawing;
  try {
    draw_into(drawing, graphics, job, shot);
  } catch (const InputError& problem) {
    drawing.error = problem.what();
  } catch (const std::bad_alloc&) {
    drawing.error = "there is no memory left for that";
  }
  drawing.milliseconds = now_ms() - began;
  return drawing;
}

}  // namespace

void draw(gl::Graphics& graphics, const Job& job,
          const std::function<void(std::size_t shot, Drawing)>& each) {
  if (graphics.width() != job.width || graphics.height() != job.height) {
    throw InputError(
        fmt::format("a job of {}x{} pixels needs a frame of that size", job.width, job.height));
  }
  for (std::size_t i = 0; i < job.shots.size(); ++i) each(i, drawn(graphics, job, job.shots[i]));
}

}  // namespace shadowlab::lab
