// Each lab of labs/: what is right gets all marks, what is wrong does not.
#include <gmock/gmock.h>

#include <algorithm>
#include <span>

#include "core/version.h"
#include "lab/grade.h"
#include "lab_fixture.h"

namespace shadowlab::lab {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> lab_names() {
  std::vector<std::string> names;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(home() / "labs", none)) {
    if (fs::exists(entry.path() / "lab.lua")) names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

class EachLab : public testing::TestWithParam<std::string> {
 protected:
  EachLab()
      : lab_(load_lab(home() / "labs" / GetParam())),
        graphics_(context::create(), lab_.width, lab_.height),
        reference_(draw_reference(graphics_, lab_)) {}

  Result graded(const fs::path& recipe) {
    const DrawSubmission in_process = [this](const Job& job, const auto& each) {
      draw(graphics_, job, each);
      return Drawn{};
    };
    return grade(lab_, reference_, {recipe.stem().string(), recipe, {}, {}}, in_process, {});
  }

  // One takes the way of all through our code, and sanitizers take ten times as long.
  std::size_t mistakes_drawn() const {
#ifdef __SANITIZE_ADDRESS__
    return std::min<std::size_t>(1, lab_.mistakes.size());
#else
    return lab_.mistakes.size();
#endif
  }

  static std::string said(const Result& result) {
    std::string all = result.error;
    for (const CaseResult& one : result.cases) {
      all += "\n" + one.name + ":";
      for (const std::string& sentence : one.says) all += " " + sentence;
    }
    return all;
  }

  Lab lab_;
  gl::Graphics graphics_;
  Reference reference_;
};

TEST_P(EachLab, gives_all_marks_to_what_is_right_in_another_way) {
  const Result solution = graded(lab_.solution());
  EXPECT_EQ(solution.score, lab_.points) << said(solution);
  for (const fs::path& alternative : lab_.alternatives) {
    const Result result = graded(alternative);
    EXPECT_EQ(result.score, lab_.points) << alternative << said(result);
  }
}

TEST_P(EachLab, gives_the_template_no_more_than_its_floor) {
  const Result result = graded(lab_.start());
  EXPECT_LE(100 * result.score, lab_.floor * lab_.points) << said(result);
  EXPECT_EQ(result.error, "") << "the template runs";
}

TEST_P(EachLab, takes_marks_for_each_mistake_and_knows_it_again) {
  for (const Mistake& mistake : std::span(lab_.mistakes).first(mistakes_drawn())) {
    const Result result = graded(mistake.file);
    EXPECT_LT(result.score, lab_.points) << mistake.name;
    std::string hints;
    for (const CaseResult& one : result.cases) {
      if (one.finding) hints += one.finding->mistake + " ";
    }
    // Two mistakes may draw the same pictures: then the first one's hint is given.
    EXPECT_NE(hints, "") << mistake.name << said(result);
  }
}

INSTANTIATE_TEST_SUITE_P(Labs, EachLab, testing::ValuesIn(lab_names()),
                         [](const auto& lab) { return lab.param; });
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(EachLab);

}  // namespace
}  // namespace shadowlab::lab
