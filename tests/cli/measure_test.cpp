// shadowlab measure: its files, how it goes on after an interruption, and what it refuses.
#include <gmock/gmock.h>

#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "program.h"

namespace shadowlab::cli_tests {
namespace {

using testing::AnyOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

constexpr const char* small =
    "measure soft_accumulated shadow_map_cube --scene tetra --size 16 --quick --bar 0.05 -o 'a "
    "report'";

class Measure : public Cli {
 protected:
  fs::path report(const char* name) const { return folder / "a report" / name; }
  std::vector<std::string> journal() const {
    std::istringstream lines(text_of(report("journal.jsonl")));
    std::vector<std::string> all;
    for (std::string line; std::getline(lines, line);) all.push_back(line);
    return all;
  }
};

TEST_F(Measure, writes_a_table_a_record_that_keeps_its_schema_and_a_page_that_stands_alone) {
  const Ended ended = run(small);
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(ended.err, "") << "silent in a pipe";
  EXPECT_EQ(std::system(("python3 -m jsonschema -i '" + report("measure.json").string() + "' '" +
                         report("measure.schema.json").string() + "'")
                            .c_str()),
            0);
  const auto record = nlohmann::json::parse(text_of(report("measure.json")));
  for (const auto& point : record.at("points")) {
    EXPECT_FALSE(point.contains("left_out")) << point.at("name");
    EXPECT_GE(point.at("error").at("rmse"), point.at("error").at("bar")) << point.at("name");
  }
  EXPECT_THAT(text_of(report("measure.csv")),
              HasSubstr("tetra,shadow_map_cube,size=128,false,hard,"));
  const std::string page = text_of(report("report.html"));
  EXPECT_THAT(page, HasSubstr("data:image/png;base64,"));
  for (const char* fetched : {"src=\"http", "href=\"http", "@import", "<link"})
    EXPECT_THAT(page, Not(HasSubstr(fetched)));
}

TEST_F(Measure, goes_on_where_it_was_interrupted) {
  ASSERT_EQ(run(small).code, 0);
  const auto whole = journal();
  // As if it had been killed in the middle of a line.
  std::string cut;
  for (std::size_t i = 0; i < whole.size() / 2; ++i) cut += whole[i] + "\n";
  write("a report/journal.jsonl", cut + whole[whole.size() / 2].substr(0, 9));
  ASSERT_EQ(run(small).code, 0);
  const auto again = journal();
  ASSERT_EQ(again.size(), whole.size());
  std::map<std::string, int> keys;
  for (std::size_t i = 0; i < again.size(); ++i) {
    if (i < whole.size() / 2) {
      EXPECT_EQ(again[i], whole[i]) << "measured twice";
    }
    ++keys[nlohmann::json::parse(again[i]).at("key").get<std::string>()];
  }
  EXPECT_EQ(keys.size(), again.size());
}

TEST_F(Measure, prints_its_figures_as_tables_of_a_run_that_is_there) {
  ASSERT_EQ(run(small).code, 0);
  const auto before = journal();
  const Ended ended = run(std::string(small) + " --table");
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(journal(), before) << "measured again";
  for (const char* part :
       {"| tetra, hard | `shadow_map_cube`", "| tetra, soft | `soft_accumulated`", "| time over |",
        "| `shadow_map_cube` |", "| million rays/s |"})
    EXPECT_THAT(ended.out, HasSubstr(part));
  // Each row has as many cells as the head of its table.
  std::istringstream lines(ended.out);
  std::ptrdiff_t cells = 0;
  for (std::string line; std::getline(lines, line);) {
    const auto bars = std::count(line.begin(), line.end(), '|');
    if (bars == 0) cells = 0;
    if (bars > 0 && cells == 0) cells = bars;
    EXPECT_EQ(bars, cells) << line;
  }
}

// The cube's faces are drawn in the first frame alone: its times are those of the scene's pass.
TEST_F(Measure, times_of_passes_go_by_their_names_where_a_map_is_kept) {
  ASSERT_EQ(run(small).code, 0);
  const auto record = nlohmann::json::parse(text_of(report("measure.json")));
  int faces = 0, scenes = 0;
  for (const auto& point : record.at("points")) {
    if (point.at("recipe") != "shadow_map_cube") continue;
    for (const auto& pass : point.at("passes")) {
      const bool face = pass.at("name").get<std::string>().starts_with("1. face");
      const double ms = pass.at("ms").at("median").get<double>();
      EXPECT_EQ(ms == 0, face) << pass.dump();
      ++(face ? faces : scenes);
    }
  }
  EXPECT_GT(faces, 0);
  EXPECT_GT(scenes, 0);
}

TEST_F(Measure, refuses_to_mix_two_measurements) {
  ASSERT_EQ(run(small).code, 0);
  const std::string other = std::string(small) + " --radius 0.3";
  expect_sentence(run(other), 2, "a report holds a measurement with other options");
  EXPECT_EQ(run(other + " --fresh").code, 0);
}

TEST_F(Measure, says_what_cannot_be_measured) {
  expect_sentence(run("measure volume_zfail"), 2, "did you mean volumes_zfail?");
  expect_sentence(run("measure stencil_basics"), 2, "is not held against a truth");
  expect_sentence(run("measure volumes_zfail --scene nowhere"), 2, "nowhere");
  expect_sentence(run("measure --bar 7"), 2, "--bar");
  write("file", "");
  expect_sentence(run("measure volumes_zfail -o file"), 2, "file");
}

TEST_F(Measure, a_recipe_that_fails_is_left_out_with_its_reason) {
  write("bad.lua", R"(return { scene = "tetra", truth = "hard",
    params = { light = param.point(2, 4, 1) }, draw = function() error("my mistake") end })");
  ASSERT_EQ(run("measure bad.lua --scene tetra --size 16 --quick -o out").code, 0);
  const auto record = nlohmann::json::parse(text_of(folder / "out/measure.json"));
  for (const auto& point : record.at("points"))
    EXPECT_THAT(point.at("left_out").get<std::string>(), HasSubstr("my mistake"));
}

TEST_F(Measure, a_sweep_of_no_parameter_is_an_error_that_names_the_near_one) {
  write("bad.lua", R"(return { scene = "tetra", truth = "hard", sweep = { sise = { 1 } },
    params = { light = param.point(2, 4, 1), size = param.integer(3, 1, 9) }, draw = function() end })");
  expect_sentence(run("measure bad.lua"), 2, "sweep.sise is no parameter; did you mean size?");
}

// The page in a browser 400 pixels wide: its script comes to its end, and draws what the report
// has; nothing but tables, which scroll, is wider than the window; nothing is fetched from
// anywhere; and with a plot in focus the arrow keys walk from its fastest point on, with the
// pictures behind it.
TEST_F(Measure, the_page_draws_itself_in_a_narrow_browser_and_answers_to_keys) {
  ASSERT_EQ(run(small).code, 0);
  std::string page = text_of(folder / "a report/report.html");
  EXPECT_THAT(page,
              Not(AnyOf(HasSubstr("src=\"http"), HasSubstr("href=\"http"), HasSubstr("@import"))));
  page.insert(page.rfind("</body>"), R"(<script>
    const plotted = document.querySelector("canvas[tabindex]");
    plotted.focus();
    const press = (key) => plotted.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true }));
    const told = () => document.querySelector(".chosen strong")?.textContent ?? "nothing";
    press("ArrowRight");
    const first = told();
    press("ArrowRight");
    document.body.append(`keys: ${document.activeElement === plotted} ${first} then ${told() === first ? "the same" : told().startsWith("shadow_map_cube") ? "another" : told()},`
      + ` ${document.querySelectorAll(".chosen img").length} pictures,`
      + ` ${document.documentElement.scrollWidth <= document.documentElement.clientWidth ? "fits" : "too wide"}`);
    </script>)");
  write("a report/with keys.html", page);
  const Ended ended =
      run("--version >/dev/null; HOME=\"$PWD\" chromium --headless --no-sandbox --disable-gpu "
          "--window-size=400,800 --virtual-time-budget=20000 --dump-dom 'a report/with keys.html'");
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("data-ready=\"yes\""));
  EXPECT_THAT(ended.out, HasSubstr("The Pareto front in tetra"));
  EXPECT_THAT(
      ended.out,
      ContainsRegex("keys: true shadow_map_cube[ a-z=0-9]* then another, 3 pictures, fits"));
}

}  // namespace
}  // namespace shadowlab::cli_tests
