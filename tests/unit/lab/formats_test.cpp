// Results as other programs take them: the fields that their documentation names, and no others.
#include "lab/formats.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <set>

#include "core/error.h"
#include "image/image.h"
#include "lab/report.h"
#include "lab_fixture.h"

namespace shadowlab::lab {
namespace {

using nlohmann::json;
using testing::HasSubstr;

CaseResult a_case(const std::string& name, double most, Status status) {
  CaseResult one;
  one.name = name;
  one.most = most;
  one.status = status;
  return one;
}

Result a_result() {
  Result result;
  result.submission = "Núria <b> & \"Pol\"";
  result.file = "shadow.lua";
  result.lab = "06_projected_stencil";
  result.title = "A projected shadow";
  result.most = 10;
  result.score = 0.1 + 0.2 + 3;
  result.seconds = 1.2;
  result.digest = 0xFEDCBA9876543210u;
  result.trace = 3;
  result.verdict = "finished";
  CaseResult right = a_case("light above", 3.3, Status::passed);
  right.points = 3.3;
  right.says = {"Right."};
  CaseResult wrong = a_case("elsewhere", 3.7, Status::failed);
  wrong.says = {"The picture differs.", "The mask \x01 <is> off."};
  wrong.finding =
      Finding{"2. the shadow", 2, "stencil", "lit", "top", 9, "mask", "hint", "s", true};
  wrong.settings = {"light=0,4,0"};
  wrong.pictures = {{"yours", "case-2-yours.png"}};
  CaseResult secret = a_case("secret", 3, Status::error);
  secret.hidden = true;
  secret.says = {"It was not drawn."};
  result.cases = {right, wrong, secret};
  return result;
}

std::set<std::string> names(const json& object) {
  std::set<std::string> found;
  for (const auto& [name, value] : object.items()) found.insert(name);
  return found;
}

TEST(Results, come_back_from_their_file_as_they_were) {
  const Result result = a_result();
  const std::string text = text_of(to_json(result));
  EXPECT_EQ(text_of(to_json(result_from(json::parse(text)))), text);
}

TEST(Results, what_is_no_result_is_refused) {
  EXPECT_THROW(result_from(json::parse("{\"submission\": 3}")), InputError);
}

TEST(Gradescope, has_the_fields_of_its_specification) {
  const json said = json::parse(as_gradescope(a_result()));
  EXPECT_EQ(names(said), (std::set<std::string>{"score", "execution_time", "tests"}));
  EXPECT_EQ(said["score"].dump(), "3.3");
  EXPECT_EQ(said["execution_time"].dump(), "2");
  ASSERT_EQ(said["tests"].size(), 3u);
  const json& test = said["tests"][1];
  EXPECT_EQ(names(test), (std::set<std::string>{"score", "max_score", "name", "number", "output",
                                                "output_format", "visibility", "status"}));
  EXPECT_EQ(test["number"], "2");
  EXPECT_EQ(test["status"], "failed");
  EXPECT_EQ(test["visibility"], "visible");
  EXPECT_THAT(test["output"].get<std::string>(), HasSubstr("The mask"));
  EXPECT_EQ(said["tests"][0]["status"], "passed");
  EXPECT_EQ(said["tests"][2]["status"], "failed");
  EXPECT_EQ(said["tests"][2]["visibility"], "hidden");
}

TEST(Gradescope, says_why_nothing_was_drawn) {
  Result result = a_result();
  result.error = "shadow.lua:3: no";
  const json said = json::parse(as_gradescope(result));
  EXPECT_EQ(said["output"], "shadow.lua:3: no");
  EXPECT_EQ(said["output_format"], "text");
}

TEST(PrairieLearn, has_a_score_from_0_to_1_and_pictures_as_data) {
  const Folder folder;
  image::write_png(folder.path() / "case-2-yours.png", image::Image(8, 8));
  const json said = json::parse(as_prairielearn(a_result(), folder.path()));
  EXPECT_EQ(names(said), (std::set<std::string>{"gradable", "score", "output", "tests"}));
  EXPECT_DOUBLE_EQ(said["score"].get<double>(), 0.33);
  const json& test = said["tests"][1];
  EXPECT_EQ(names(test),
            (std::set<std::string>{"name", "points", "max_points", "output", "images"}));
  EXPECT_THAT(test["images"][0]["url"].get<std::string>(),
              testing::StartsWith("data:image/png;base64,iVBORw0KGgo"));
  EXPECT_EQ(said["tests"][2]["output"], "") << "of a hidden case";
}

TEST(PrairieLearn, stays_under_a_megabyte) {
  const Folder folder;
  image::Image noise(512, 512);
  std::uint32_t word = 1;
  for (std::uint8_t& byte : noise.rgba)
    byte = static_cast<std::uint8_t>((word = word * 1664525u + 1013904223u) >> 24);
  image::write_png(folder.path() / "case-2-yours.png", noise);
  const std::string text = as_prairielearn(a_result(), folder.path());
  EXPECT_LT(text.size(), 1'000'000u);
  EXPECT_FALSE(json::parse(text)["tests"][1].contains("images"));
}

TEST(Autolab, is_one_line_of_scores_by_name) {
  const std::string line = as_autolab(a_result());
  EXPECT_EQ(line, "{\"scores\":{\"light above\":3.3,\"elsewhere\":0.0,\"secret\":0.0}}\n");
}

TEST(JUnit, counts_failures_and_errors_and_is_xml) {
  const Result result = a_result();
  const std::string xml = as_junit(std::span(&result, 1));
  EXPECT_THAT(xml, HasSubstr("<testsuites tests=\"3\" failures=\"1\" errors=\"1\">"));
  EXPECT_THAT(xml, HasSubstr("name=\"Núria &lt;b&gt; &amp; &quot;Pol&quot;\""));
  EXPECT_THAT(xml, HasSubstr("<failure message=\"The picture differs. The mask   &lt;is"));
  EXPECT_EQ(xml.find('\x01'), std::string::npos);
}

TEST(Csv, is_no_formula_for_a_spreadsheet) {
  Result result = a_result();
  result.submission = "=HYPERLINK(\"x\")";
  EXPECT_THAT(scores_csv(std::span(&result, 1)), HasSubstr("\n\"'=HYPERLINK(\"\"x\"\")\",3.3"));
}

TEST(Report, shows_names_as_text) {
  const Result result = a_result();
  const std::string html = report_page(result, Language::english, Hidden::left_out);
  EXPECT_THAT(html, HasSubstr("Núria &lt;b&gt; &amp; &quot;Pol&quot;"));
  EXPECT_EQ(html.find("<b>"), std::string::npos);
}

TEST(Report, leaves_out_what_is_hidden) {
  const Result result = a_result();
  const std::string hidden = report_page(result, Language::english, Hidden::left_out);
  EXPECT_EQ(hidden.find("case-3"), std::string::npos);
  EXPECT_THAT(report_page(result, Language::english, Hidden::shown), HasSubstr("case-3-expected"));
}

TEST(Report, asks_nothing_of_the_network) {
  const Result result = a_result();
  for (const std::string& html : {report_page(result, Language::french, Hidden::shown),
                                  class_page(std::span(&result, 1), Language::catalan)}) {
    EXPECT_EQ(html.find("http"), std::string::npos);
    EXPECT_EQ(html.find("//"), std::string::npos);
  }
}

TEST(Sentences, are_there_in_every_language_with_the_same_blanks) {
  for (int i = 0; i < static_cast<int>(Say::count); ++i) {
    std::set<std::string> blanks[4];
    for (int language = 0; language < 4; ++language) {
      const std::string_view said = text(static_cast<Language>(language), static_cast<Say>(i));
      EXPECT_FALSE(said.empty()) << i;
      for (std::size_t at = 0; (at = said.find('{', at)) != std::string_view::npos; ++at)
        blanks[language].insert(std::string(said.substr(at, 3)));
      EXPECT_EQ(blanks[language], blanks[0]) << said;
    }
  }
}

}  // namespace
}  // namespace shadowlab::lab
