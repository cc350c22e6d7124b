// A submission is judged by what it draws when it is asked for a mark, and by nothing that it draws
// later.
#include "lab/grade.h"

#include <gmock/gmock.h>

#include "lab_fixture.h"

namespace shadowlab::lab {
namespace {

std::string clearing_to(std::string_view color) {
  return recipe_text(fmt::format(
      "pass('1. the ground', function() gl.ClearColor({}) gl.Clear(gl.COLOR_BUFFER_BIT) end)",
      color));
}

class Grade : public LabTest {
 protected:
  Grade() {
    folder_.write("lab.lua",
                  fmt::format("return {{ title = 'T', points = 10, size = {{{0}, {0}}},\n cases = "
                              "{{ {{ name = 'a', compare = {{ color = true }} }} }} }}\n",
                              frame_size));
    folder_.write("template.lua", clearing_to("0, 0, 0, 1"));
    folder_.write("solution.lua", clearing_to("1, 0, 0, 1"));
    folder_.write("wrong.lua", clearing_to("0, 0, 1, 1"));
    lab_ = load_lab(folder_.path());
    reference_.emplace(draw_reference(graphics(), lab_));
  }

  /// Of a submission that draws `first` when asked the first time, and `later` from then on.
  Result graded(const char* first, const char* later) {
    const DrawSubmission in_process = [&](const Job& given, const auto& each) {
      jobs_.push_back(given);
      Job job = given;
      job.recipe = folder_.path() / (jobs_.size() == 1 ? first : later);
      draw(graphics(), job, each);
      return Drawn{};
    };
    return grade(lab_, *reference_, {"s", folder_.path() / first, {}, {}}, in_process, {});
  }

  const std::vector<Job>& jobs() const { return jobs_; }

 private:
  Folder folder_;
  Lab lab_;
  std::optional<Reference> reference_;
  std::vector<Job> jobs_;
};

TEST_F(Grade, a_right_submission_is_asked_for_what_is_compared_and_once) {
  EXPECT_TRUE(graded("solution.lua", "wrong.lua").passed());
  ASSERT_EQ(jobs().size(), 1u);
  EXPECT_EQ(jobs()[0].frame, (Kept{.color = true}));
  EXPECT_EQ(jobs()[0].passes, Kept{});
}

TEST_F(Grade, a_wrong_one_is_explained_by_all_that_its_passes_leave) {
  const Result result = graded("wrong.lua", "wrong.lua");
  EXPECT_EQ(result.score, 0);
  ASSERT_GE(jobs().size(), 2u);
  EXPECT_EQ(jobs()[1].passes, everything);
  ASSERT_TRUE(result.cases[0].finding);
  EXPECT_EQ(result.cases[0].finding->pass, "1. the ground");
}

TEST_F(Grade, what_is_drawn_otherwise_the_second_time_gives_no_mark) {
  EXPECT_EQ(graded("wrong.lua", "solution.lua").score, 0);
}

TEST_F(Grade, what_is_drawn_otherwise_the_second_time_explains_nothing) {
  const Result result = graded("wrong.lua", "template.lua");
  EXPECT_EQ(result.score, 0);
  ASSERT_TRUE(result.cases[0].finding);
  EXPECT_EQ(result.cases[0].finding->pass, "");
}

}  // namespace
}  // namespace shadowlab::lab
