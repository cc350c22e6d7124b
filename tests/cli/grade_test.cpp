// shadowlab grade, merge, pack: marks, files, and what is left of a run that was stopped.
#include <gmock/gmock.h>

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "program.h"

namespace shadowlab::cli_tests {
namespace {

using nlohmann::json;
using testing::HasSubstr;

// A picture of one colour, red as far as the parameter says.
std::string painting(const std::string& red) {
  return "local recipe = { params = { red = param.number(1, 0, 1) } }\n"
         "function recipe.draw(r)\n"
         "  pass('1. paint', function()\n"
         "    gl.ClearColor(" +
         red +
         ", 0, 0, 1)\n"
         "    gl.Clear(gl.COLOR_BUFFER_BIT)\n"
         "  end)\n"
         "end\n"
         "return recipe\n";
}

class GradeCli : public Cli {
 protected:
  GradeCli() {
    for (const char* name : {"lab", "lab/mistakes", "in"}) fs::create_directory(folder / name);
    write("lab/lab.lua",
          "return { title = 'Paint', points = 4, size = {16, 16}, cases = {\n"
          "  { name = 'quarter', points = 1, set = { red = 0.25 } },\n"
          "  { name = 'secret', points = 3, hidden = true, set = { red = random.number(0.6, 0.9) } "
          "} } }\n");
    write("lab/solution.lua", painting("r.params.red"));
    write("lab/template.lua", painting("0"));
    write("lab/README.md", "# Paint\n");
    write("lab/mistakes/inverted.lua",
          "-- hint: The colour is inverted.\n-- hint.fr: La couleur est inversée.\n" +
              painting("1 - r.params.red"));
  }

  json result(const std::string& name, const std::string& out = "graded") const {
    return json::parse(text_of(folder / out / "submissions" / name / "result.json"));
  }
};

TEST_F(GradeCli, all_marks_end_with_0_and_lost_ones_with_1) {
  write("right.lua", painting("r.params.red"));
  write("wrong.lua", painting("0.25"));
  EXPECT_EQ(run("grade lab right.lua").code, 0);
  const Ended ended = run("grade lab wrong.lua -o other");
  EXPECT_EQ(ended.code, 1) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("1 / 4"));
  EXPECT_EQ(result("right")["score"], 4);
  EXPECT_EQ(result("wrong", "other")["score"], 1);
  EXPECT_TRUE(has("other/index.html"));
  EXPECT_TRUE(has("other/submissions/wrong/report.html"));
}

TEST_F(GradeCli, a_known_mistake_is_told_by_its_hint_in_the_language_asked_for) {
  write("wrong.lua", painting("1 - r.params.red * 1"));
  EXPECT_THAT(run("grade lab wrong.lua").out, HasSubstr("The colour is inverted."));
  EXPECT_THAT(run("grade lab wrong.lua -o fr --lang fr").out,
              HasSubstr("La couleur est inversée."));
}

// The state that is named is the one without which the picture is right.
TEST_F(GradeCli, a_state_is_told_with_what_would_mend_the_picture) {
  const auto drawing = [](const std::string& mask) {
    return "local recipe = { params = { red = param.number(1, 0, 1) } }\n"
           "function recipe.setup(r) r.flat = shader.load 'flat' end\n"
           "function recipe.draw(r)\n"
           "  pass('1. a quad', function()\n"
           "    gl.Disable(gl.CULL_FACE)\n"
           "    gl.DepthFunc(gl.LEQUAL)\n"
           "    gl.ColorMask(true, " +
           mask +
           ", true, true)\n"
           "    local one = mat4.identity()\n"
           "    mesh.quad():draw(r.flat, { view = one, projection = one, color = "
           "vec3(r.params.red) })\n"
           "  end)\n"
           "end\n"
           "return recipe\n";
  };
  write("lab/solution.lua", drawing("true"));
  write("lab/mistakes/inverted.lua", "-- hint: The mask.\n" + painting("0.9"));
  write("wrong.lua", drawing("false"));
  run("grade lab wrong.lua");
  const json finding = result("wrong")["cases"][0]["finding"];
  EXPECT_THAT(finding["state"].dump(), HasSubstr("colour mask TRUE FALSE TRUE TRUE")) << finding;
  EXPECT_EQ(finding["mended"], true);
}

TEST_F(GradeCli, another_state_is_told_in_words) {
  write("wrong.lua", painting("r.params.red * 0.9"));
  run("grade lab wrong.lua");
  const json said = result("wrong")["cases"][0]["says"];
  EXPECT_THAT(said.dump(), HasSubstr("The first pass that departs is \\\"1. paint\\\""));
  EXPECT_THAT(said.dump(), HasSubstr("0.225f 0.0f 0.0f 1.0f where the reference has 0.25f"));
}

TEST_F(GradeCli, hidden_cases_tell_neither_settings_nor_pictures) {
  write("wrong.lua", painting("0.1"));
  run("grade lab wrong.lua");
  const json hidden = result("wrong")["cases"][1];
  EXPECT_TRUE(hidden["settings"].empty());
  EXPECT_TRUE(hidden["pictures"].empty());
  EXPECT_FALSE(has("graded/expected/case-2-expected.png"));
  run("grade lab wrong.lua -o shown --show-hidden");
  EXPECT_TRUE(has("shown/expected/case-2-expected.png"));
  EXPECT_FALSE(result("wrong", "shown")["cases"][1]["settings"].empty());
}

TEST_F(GradeCli, a_recipe_that_fails_is_told_by_its_own_name_and_line) {
  write("in/bad one.lua", "return {\n");
  EXPECT_EQ(run("grade lab in").code, 1);
  const std::string error = result("bad one")["error"];
  EXPECT_TRUE(error.starts_with("bad one.lua:")) << error;
}

TEST_F(GradeCli, a_folder_is_a_class_of_files_and_folders) {
  write("in/ada.lua", painting("r.params.red"));
  fs::create_directory(folder / "in/submission_17");
  write("in/submission_17/shadow.lua", painting("r.params.red"));
  write("in/submission_17/metadata.yml", "x: 1\n");
  fs::create_directory(folder / "in/empty");
  fs::create_symlink("/etc/passwd", folder / "in/link.lua");
  EXPECT_EQ(run("grade lab in").code, 1);
  EXPECT_EQ(result("ada")["score"], 4);
  EXPECT_EQ(result("submission_17")["score"], 4);
  EXPECT_THAT(result("empty")["error"].dump(), HasSubstr("no .lua file"));
  EXPECT_FALSE(has("graded/submissions/link"));
}

TEST_F(GradeCli, submissions_see_no_file_of_another) {
  write("in/secret.lua", "return { mine = 1 }\n");
  write("in/thief.lua", "local s = require 'secret'\n" + painting("r.params.red"));
  run("grade lab in");
  EXPECT_THAT(result("thief")["error"].dump(), HasSubstr("there is no secret.lua"));
}

TEST_F(GradeCli, an_export_may_be_an_archive) {
  write("in/ada.lua", painting("r.params.red"));
  fs::create_directory(folder / "in/Bob Müller_12_assignsubmission_file_");
  write("in/Bob Müller_12_assignsubmission_file_/shadow.lua", painting("r.params.red"));
  ASSERT_EQ(std::system(("cd '" + folder.string() +
                         "' && python3 -m zipfile -c export.zip in/* && rm -r in")
                            .c_str()),
            0);
  EXPECT_EQ(run("grade lab export.zip").code, 0);
  EXPECT_EQ(result("Bob Müller_12_assignsubmission_file_")["score"], 4);
  write("broken.zip", "PK no");
  expect_sentence(run("grade lab broken.zip -o other"), 2, "broken.zip: this zip archive cannot");
}

TEST_F(GradeCli, a_new_lab_gives_its_solution_all_marks_and_its_template_none) {
  EXPECT_EQ(run("new lab my_lab").code, 0);
  EXPECT_EQ(run("grade my_lab my_lab/solution.lua -o right").code, 0);
  EXPECT_THAT(run("grade my_lab my_lab/template.lua -o wrong").out, HasSubstr("0 / 10"));
  EXPECT_THAT(run("grade my_lab my_lab/mistakes -o mistakes").out, HasSubstr("right to left"));
  expect_sentence(run("new lab my_lab"), 2, "my_lab exists already");
}

TEST_F(GradeCli, one_takes_a_folder_with_the_files_beside_the_recipe) {
  write("in/submission.lua", "local part = require 'part'\n" + painting("part.of(r)"));
  write("in/part.lua", "return { of = function(r) return r.params.red end }\n");
  EXPECT_EQ(run("grade lab in --one").code, 0);
  EXPECT_EQ(result("in")["score"], 4);
}

TEST_F(GradeCli, a_run_is_taken_up_where_it_was_left) {
  write("in/ada.lua", painting("r.params.red"));
  write("in/bob.lua", painting("0.25"));
  run("grade lab in");
  const auto when = fs::last_write_time(folder / "graded/submissions/ada/result.json");
  const std::string bob = result("bob")["cases"].dump();
  fs::remove(folder / "graded/submissions/bob/result.json");
  write("graded/submissions/bob/.result.json.1-0.tmp", "{");
  write("graded/expected/.case-1-expected.png.1-1.tmp", "half of it");
  EXPECT_EQ(run("grade lab in").code, 1);
  EXPECT_EQ(fs::last_write_time(folder / "graded/submissions/ada/result.json"), when);
  EXPECT_EQ(result("bob")["score"], 1);
  EXPECT_FALSE(has("graded/submissions/bob/.result.json.1-0.tmp"));
  EXPECT_FALSE(has("graded/expected/.case-1-expected.png.1-1.tmp"));
  write("in/ada.lua", painting("0.25"));
  run("grade lab in");
  EXPECT_EQ(result("ada")["score"], 1) << "what is handed in anew is graded anew";
}

// Killed at any moment and started again: the same results, none lost, none twice. A run that comes
// to its end makes room for the next, so that each kill meets one at work. SHADOWLAB_KILLS says how
// often.
TEST_F(GradeCli, a_run_that_is_killed_again_and_again_ends_as_one_that_is_not) {
  constexpr int submissions = 12;
  for (int i = 0; i < submissions; ++i)
    write(fmt::format("in/s{}.lua", i), painting(i % 3 == 0 ? "0.25" : "r.params.red"));
  run("grade lab in -o whole --jobs 2");
  const auto expect_whole = [&] {
    EXPECT_EQ(text_of(folder / "killed/scores.csv"), text_of(folder / "whole/scores.csv"));
    int results = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder / "killed")) {
      results += entry.path().filename() == "result.json";
      EXPECT_NE(entry.path().extension(), ".tmp") << entry.path();
    }
    EXPECT_EQ(results, submissions);
  };
  const char* given = std::getenv("SHADOWLAB_KILLS");
  const int kills = given ? std::atoi(given) : 8;
  int killed = 0, whole = 0;
  std::uint32_t word = 1;
  while (killed < kills) {
    word = word * 1664525u + 1013904223u;
    const double after = 0.1 + 0.5 * (word >> 8) / double(1 << 24);
    // In the foreground timeout waits until who it killed is gone, and its lock with it; else it
    // kills itself first, and the next run may find the folder still taken.
    const int code = run("grade lab in -o killed --jobs 2",
                         fmt::format("timeout --foreground -s KILL {:.3f}", after))
                         .code;
    // 124: it was at its end by itself when the time was.
    ASSERT_TRUE(code == 1 || code == 128 + 9 || code == 124) << code;
    killed += code != 1;
    if (code != 1) continue;
    ++whole;
    expect_whole();
    fs::remove_all(folder / "killed");
  }
  EXPECT_EQ(run("grade lab in -o killed --jobs 2").code, 1);
  expect_whole();
  if (given) fmt::print("{} kills, over {} runs\n", killed, whole + 1);
}

TEST_F(GradeCli, a_report_shows_its_pictures_in_a_browser) {
  if (std::system("command -v chromium >/dev/null") != 0) GTEST_SKIP() << "there is no chromium";
  write("wrong.lua", painting("0.75"));
  run("grade lab wrong.lua");
  const std::string command =
      "cd '" + folder.string() +
      "' && HOME=. timeout 60 chromium --headless --no-sandbox --disable-gpu "
      "--dump-dom \"file://$PWD/graded/submissions/wrong/report.html\" "
      ">.dom 2>/dev/null";
  ASSERT_EQ(std::system(command.c_str()), 0);
  const std::string dom = text_of(folder / ".dom");
  // The script has run: half of the slider's way shows yours, and nothing of the difference.
  EXPECT_THAT(dom, HasSubstr("class=\"difference\""));
  EXPECT_THAT(dom, HasSubstr("clip-path: inset(0px 100% 0px 0px)"));
}

TEST_F(GradeCli, a_folder_of_another_run_is_refused) {
  write("a.lua", painting("0"));
  run("grade lab a.lua");
  expect_sentence(run("grade lab a.lua --seed 7"), 2, "graded holds results of another run");
}

TEST_F(GradeCli, shards_together_say_what_one_run_says) {
  for (const char* name : {"a", "b", "c", "d", "e"})
    write(std::string("in/") + name + ".lua", painting(name[0] == 'c' ? "0" : "r.params.red"));
  run("grade lab in -o whole");
  EXPECT_EQ(run("grade lab in -o s1 --shard 1/2").code, 1);
  EXPECT_EQ(run("grade lab in -o s2", "GTEST_SHARD_INDEX=1 GTEST_TOTAL_SHARDS=2").code, 0);
  EXPECT_EQ(run("merge s1 s2 -o all").code, 0);
  EXPECT_EQ(text_of(folder / "all/scores.csv"), text_of(folder / "whole/scores.csv"));
  EXPECT_EQ(json::parse(text_of(folder / "all/results.json")).size(), 5u);
}

TEST_F(GradeCli, a_shard_without_submissions_is_merged_too) {
  write("a.lua", painting("r.params.red"));
  run("grade lab a.lua -o s1 --shard 1/2");
  EXPECT_EQ(run("grade lab a.lua -o s2 --shard 2/2").code, 0);
  EXPECT_EQ(run("merge s1 s2 -o all").code, 0);
  EXPECT_EQ(json::parse(text_of(folder / "all/results.json")).size(), 1u);
}

TEST_F(GradeCli, shards_of_two_runs_are_not_merged) {
  write("a.lua", painting("0"));
  run("grade lab a.lua -o s1 --shard 1/2 --seed 1");
  run("grade lab a.lua -o s2 --shard 1/2 --seed 2");
  expect_sentence(run("merge s1 s2 -o all"), 2, "of another lab or seed");
}

TEST_F(GradeCli, a_shard_that_is_none_is_refused) {
  write("a.lua", painting("0"));
  expect_sentence(run("grade lab a.lua --shard 3/2"), 2, "--shard takes I/N");
  expect_sentence(run("grade lab a.lua", "SLURM_ARRAY_TASK_ID=9 SLURM_ARRAY_TASK_COUNT=2"), 2,
                  "name no shard");
}

TEST_F(GradeCli, gradescope_gets_results_of_one_beside_nothing_else_to_read) {
  write("in/submission.lua", painting("0.25"));
  EXPECT_EQ(run("grade lab in --one --format gradescope -o results").code, 1);
  const json said = json::parse(text_of(folder / "results/results.json"));
  EXPECT_EQ(said["score"], 1);
  EXPECT_EQ(said["tests"][1]["visibility"], "hidden");
}

TEST_F(GradeCli, autolab_gets_its_scores_in_the_last_line) {
  write("a.lua", painting("0.25"));
  const Ended ended = run("grade lab a.lua --format autolab");
  EXPECT_TRUE(ended.out.ends_with("{\"scores\":{\"quarter\":1.0,\"secret\":0.0}}\n")) << ended.out;
}

TEST_F(GradeCli, students_get_neither_solution_nor_mistakes_nor_hidden_cases) {
  EXPECT_EQ(run("pack lab --for student -o given.zip").code, 0);
  ASSERT_EQ(std::system(
                ("cd '" + folder.string() + "' && python3 -m zipfile -e given.zip given").c_str()),
            0);
  EXPECT_TRUE(has("given/lab/template.lua"));
  EXPECT_TRUE(has("given/lab/README.md"));
  EXPECT_TRUE(has("given/lab/expected/1. quarter.png"));
  std::string all;
  for (const auto& entry : fs::recursive_directory_iterator(folder / "given"))
    all += entry.path().string() + "\n" + (entry.is_regular_file() ? text_of(entry.path()) : "");
  for (const char* word : {"solution", "mistake", "secret", "inverted", "random"})
    EXPECT_EQ(all.find(word), std::string::npos) << word;
  EXPECT_THAT(text_of(folder / "given/lab/lab.lua"), HasSubstr("red = 0.25"));
}

TEST_F(GradeCli, gradescopes_archive_runs_as_gradescope_runs_it) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "a program with sanitizers is fifty times as large: packing it takes minutes";
#endif
  EXPECT_EQ(run("pack lab --for gradescope -o auto.zip").code, 0);
  const std::string root = (folder / "autograder").string();
  const std::string in = "cd '" + folder.string() + "' && ";
  ASSERT_EQ(std::system((in + "mkdir -p autograder/submission autograder/results && python3 -m "
                              "zipfile -e auto.zip autograder/source && chmod +x "
                              "autograder/source/run_autograder autograder/source/bin/shadowlab "
                              "&& cp autograder/source/run_autograder autograder/")
                            .c_str()),
            0);
  write("autograder/submission/my_shadow.lua", painting("r.params.red"));
  EXPECT_EQ(
      std::system(
          (in + "AUTOGRADER_ROOT='" + root + "' autograder/run_autograder >.out 2>.err").c_str()),
      0)
      << text_of(folder / ".err");
  EXPECT_EQ(json::parse(text_of(folder / "autograder/results/results.json"))["score"], 4);
}

TEST_F(GradeCli, a_lab_that_is_none_is_refused_with_near_names) {
  write("a.lua", painting("0"));
  expect_sentence(run("grade 06_projected_stencl a.lua"), 2, "did you mean 06_projected_stencil?");
  expect_sentence(run("grade in a.lua"), 2, "in is no lab: there is no lab.lua in it");
  expect_sentence(run("grade lab nowhere.lua"), 2, "nowhere.lua does not exist");
  expect_sentence(run("grade lab in"), 2, "there is no submission in what was given");
  expect_sentence(run("grade lab a.lua --format xml"), 2, "--format takes json, gradescope");
  expect_sentence(run("grade lab a.lua --lang de"), 2, "--lang takes en, ca, es or fr");
}

}  // namespace
}  // namespace shadowlab::cli_tests
