// shadowlab stress: its rows, its files, and how it ends where one fails.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "program.h"

namespace shadowlab::cli_tests {
namespace {

using testing::HasSubstr;

class Stress : public Cli {
 protected:
  // A home of its own, whose hard cases are `facts`.
  void cases(const std::string& facts) const {
    for (const char* part : {"scripts", "shaders"})
      fs::create_directory_symlink(fs::path(SHADOWLAB_SOURCE_DIR) / part, folder / part);
    fs::create_directories(folder / "tests/hard");
    write("tests/hard/facts.lua", facts);
  }
  Ended stress(const std::string& arguments) const {
    return run("stress " + arguments, "SHADOWLAB_HOME=\"$PWD\"");
  }
};

constexpr const char* two_rows = R"(
local function red(r) return frame(8, 8, function() gl.ClearColor(r, 0, 0, 1) gl.Clear(gl.COLOR_BUFFER_BIT) end) end
test("one_is_one", function()
  expect_equal(1, 1)
  naive("two, as a listing has it", red(0.5))
  ours("one", red(1))
end)
test("one_is_two", function() expect_equal(1, 2) end)
row{ case = 1, title = "One", expected = "one", facts = { "one_is_one" } }
row{ case = 2, title = "Two", expected = "two", facts = { "one_is_two" }, without = "nobody says so" }
)";

TEST_F(Stress, prints_and_writes_each_row_with_its_pictures_and_ends_with_1_where_one_fails) {
  cases(two_rows);
  const Ended ended = stress("-o 'a report'");
  EXPECT_EQ(ended.code, 1) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("  1  pass  One"));
  EXPECT_THAT(ended.out, HasSubstr("listing    two, as a listing has it"));
  EXPECT_THAT(ended.out, HasSubstr("  2  FAIL  Two"));
  EXPECT_THAT(ended.out, HasSubstr("one_is_two: "));
  const auto rows = nlohmann::json::parse(text_of(folder / "a report/stress.json"));
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].at("pass"), true);
  EXPECT_EQ(rows[1].at("pass"), false);
  EXPECT_TRUE(has("a report/pictures/01_naive.png"));
  EXPECT_TRUE(has("a report/pictures/01_ours.png"));
  EXPECT_THAT(text_of(folder / "a report/stress.html"), HasSubstr("data:image/png;base64,"));
  EXPECT_THAT(text_of(folder / "a report/stress.csv"),
              HasSubstr("1,One,one,\"two, as a listing has it\",one,pass,facts\n"));
}

TEST_F(Stress, runs_the_rows_asked_for_alone) {
  cases(two_rows);
  const Ended ended = stress("1");
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, testing::Not(HasSubstr("Two")));
  expect_sentence(stress("7"), 2, "there is no row 7");
}

TEST_F(Stress, a_row_whose_listing_fails_shows_both) {
  cases(R"(
test("one_is_one", function() naive("two") ours("one") end)
row{ case = 1, title = "One", expected = "one", facts = { "one_is_one" } })");
  const Ended ended = stress("");
  EXPECT_EQ(ended.code, 1) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("does not show it"));
}

TEST_F(Stress, a_row_of_no_fact_is_an_error) {
  cases(R"(
test("a_fact", function() end)
row{ case = 1, title = "One", expected = "one", facts = { "another" } })");
  expect_sentence(stress(""), 2, "row 1: there is no test another");
}

TEST_F(Stress, without_the_source_s_cases_says_where_they_should_be) {
  for (const char* part : {"scripts", "shaders"})
    fs::create_directory_symlink(fs::path(SHADOWLAB_SOURCE_DIR) / part, folder / part);
  expect_sentence(run("stress", "SHADOWLAB_HOME=\"$PWD\""), 3, "the hard cases are in");
}

TEST_F(Stress, every_case_of_the_list_has_a_row) {
  // The quickest row of each file but one runs; that all are there is what its number says.
  const Ended ended = run("stress 19 24");
  EXPECT_EQ(ended.code, 0) << ended.out;
  std::string all;
  for (const auto& file : fs::directory_iterator(fs::path(SHADOWLAB_SOURCE_DIR) / "tests/hard")) {
    if (file.path().extension() == ".lua") all += text_of(file.path());
  }
  for (int number = 1; number <= 46; ++number)
    EXPECT_THAT(all, HasSubstr("row{ case = " + std::to_string(number) + ", "));
}

}  // namespace
}  // namespace shadowlab::cli_tests
