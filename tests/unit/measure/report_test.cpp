// What becomes of measurements: records, tables, curves, the page.
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <filesystem>

#include "core/error.h"
#include "core/version.h"
#include "measure/curves.h"
#include "measure/page.h"
#include "measure/sweep.h"
#include "measure/table.h"

namespace shadowlab::measure {
namespace {

using testing::HasSubstr;

Look a_look() {
  Look look;
  look.title = "A title";
  look.errors.pixels = 9;
  look.passes = {{"1. one", {0.25, 0, 0.5, 0}, 12, 0, 2}};
  return look;
}

TEST(Record, of_a_look_and_a_round_gives_them_back) {
  const Look look = a_look();
  EXPECT_EQ(record_of(look_of(record_of(look))), record_of(look));
  const Round round{{1, 2.5}, {{0.5}}};
  EXPECT_EQ(record_of(round_of(record_of(round))), record_of(round));
}

TEST(Record, of_a_point_has_the_quartiles_over_all_rounds_and_passes_beside_their_limits) {
  FillLimit limit;
  limit.layer = {2, 0, 4, 0};
  limit.triangle = 1000;
  limit.pass = 0.5;
  const std::vector<Round> rounds{{{1, 2}, {{0.5}}}, {{3, 4, 5}, {{1.5}}}};
  const Json point = point_of({"x/a.lua", "room", {{"size", "256"}}}, a_look(), rounds, limit);
  EXPECT_EQ(point.at("name"), "room/a size=256");
  EXPECT_EQ(point.at("frame_ms").at("median"), 3);
  EXPECT_EQ(point.at("frame_ms").at("count"), 5);
  const Json& pass = point.at("passes").at(0);
  EXPECT_EQ(pass.at("ms").at("median"), 1);
  EXPECT_EQ(pass.at("mpix"), 0.75);
  EXPECT_EQ(pass.at("fill_limit_ms"), 0.25 * 2 + 0.5 * 4);
  EXPECT_EQ(pass.at("limit_ms"), 2.5 + 12 * 1000e-6 + 2 * 0.5);
}

TEST(Table, fields_are_quoted_where_they_must_be) {
  EXPECT_EQ(csv_field("plain"), "plain");
  EXPECT_EQ(csv_field("a, \"b\"\n"), "\"a, \"\"b\"\"\n\"");
}

TEST(Table, has_as_many_fields_in_each_line_as_names) {
  Look out;
  out.left_out = "why, not";
  Json report;
  report["points"] = {point_of({"a.lua", "s", {{"n", "1"}}}, a_look(), {}, {}),
                      point_of({"b.lua", "s", {}}, out, {}, {})};
  const std::string csv = csv_of(report);
  std::vector<std::size_t> commas{0};
  bool quoted = false;
  for (const char c : csv) {
    if (c == '"') quoted = !quoted;
    if (c == ',' && !quoted) ++commas.back();
    if (c == '\n' && !quoted) commas.push_back(0);
  }
  EXPECT_EQ(commas, (std::vector<std::size_t>{commas[0], commas[0], commas[0], 0}));
  EXPECT_THAT(csv, HasSubstr("s,a,n=1,false,hard,"));
  EXPECT_THAT(csv, HasSubstr("\"why, not\""));
}

Json timed(const char* recipe, const char* size, const char* count, double ms) {
  const std::vector<Round> rounds{{{ms}, {}}};
  return point_of({recipe, "s", {{"size", size}, {"count", count}}}, a_look(), rounds, {});
}

TEST(Curves, of_a_sweep_of_two_are_each_at_the_last_of_the_other) {
  const Json points{timed("a.lua", "1", "1", 1), timed("a.lua", "2", "1", 5),
                    timed("a.lua", "4", "1", 6), timed("a.lua", "1", "2", 3),
                    timed("a.lua", "2", "2", 6), timed("a.lua", "4", "2", 12)};
  const auto curves = swept_curves(points);
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_EQ(curves[0].of, "count");
  EXPECT_EQ(curves[0].recipe, "a size=4");
  EXPECT_EQ(curves[1].recipe, "a count=2");
  EXPECT_NEAR(record_of(curves[1]).at("exponent").get<double>(), 1,
              1e-12);  // rounding of logarithms
  EXPECT_TRUE(record_of(curves[0]).at("exponent").is_null()) << "two places tell no exponent";
}

TEST(Page, what_the_report_says_cannot_leave_its_script) {
  const Json hostile = "</script><script>alert(1)</script><!--";
  const std::string text = script_text(hostile);
  EXPECT_EQ(text.find('<'), std::string::npos);
  EXPECT_EQ(Json::parse(text), hostile);
}

TEST(Page, files_are_filled_in_where_they_are_named) {
  EXPECT_EQ(filled("a{{x}}b{{x}}", {{"x", "{{y}}"}}), "a{{y}}b{{y}}") << "once";
  EXPECT_THAT(filled("<style>{{page.css}}</style>", {}), HasSubstr("prefers-color-scheme"));
  EXPECT_THROW(filled("{{nothing.js}}", {}), InputError);
}

TEST(Page, a_picture_becomes_a_url_and_a_missing_one_nothing) {
  EXPECT_EQ(data_url("/nowhere/at all.png"), "");
  EXPECT_TRUE(
      data_url(home() / "docs" / "picture.png").starts_with("data:image/png;base64,iVBORw0KGgo"));
}

TEST(Page, pictures_of_different_points_have_different_names) {
  EXPECT_NE(pictures_of("a/b size=1").error, pictures_of("a/b size=2").error);
  EXPECT_EQ(pictures_of("a/b size=1").error, "pictures/a_b_size=1.error.png");
}

}  // namespace
}  // namespace shadowlab::measure
