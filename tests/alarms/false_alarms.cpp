// A solution is right whatever draws it: threads, vector widths, contexts, another driver.
//
//   false_alarms SETTING       two of the labs, others for each setting
//   SHADOWLAB_ALARMS=all false_alarms SETTING      all labs, and what is right in another way
//
// The setting is in force for the reference, which this process draws as `shadowlab grade` does,
// and for the worker that draws the submission; and then for the reference alone. softpipe, another
// driver with GL 3.3, draws solutions alone, since some alternatives need more; and how a driver
// filters the comparisons of a depth texture GL leaves to it, so that lab 12 holds where one driver
// draws both.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>

#include "core/version.h"
#include "lab/grade.h"
#include "lab/worker.h"

namespace shadowlab::lab {
namespace {

namespace fs = std::filesystem;

struct DriverSetting {
  std::string_view name, variable, value;
  context::Backend context = context::Backend::automatic;
};
// Not a width of 512: on a processor that has AVX-512 Mesa 22.3 makes constant vectors of which it
// wrote half, and crashes at the first draw, in `shadowlab run` too.
constexpr std::array settings{
    DriverSetting{"threads_0", "LP_NUM_THREADS", "0"},
    DriverSetting{"softpipe", "GALLIUM_DRIVER", "softpipe"},
    DriverSetting{"threads_1", "LP_NUM_THREADS", "1"},
    DriverSetting{"threads_2", "LP_NUM_THREADS", "2"},
    DriverSetting{"width_128", "LP_NATIVE_VECTOR_WIDTH", "128"},
    DriverSetting{"width_256", "LP_NATIVE_VECTOR_WIDTH", "256"},
    DriverSetting{"osmesa", "", "", context::Backend::osmesa},
    DriverSetting{"egl", "", "", context::Backend::egl},
};
const DriverSetting* setting = nullptr;  // the one of this process

bool is_another_driver() { return setting->variable == "GALLIUM_DRIVER"; }

bool all_labs() {
  const char* given = std::getenv("SHADOWLAB_ALARMS");
  return given && std::string_view(given) == "all";
}

std::vector<fs::path> labs() {
  std::vector<fs::path> all;
  for (const auto& entry : fs::directory_iterator(home() / "labs")) {
    if (fs::exists(entry.path() / "lab.lua")) all.push_back(entry.path());
  }
  std::sort(all.begin(), all.end());
  if (all_labs()) return all;
  const auto first = 2 * static_cast<std::size_t>(setting - settings.data());
  return {all[first % all.size()], all[(first + 1) % all.size()]};
}

class Alarms : public testing::Test {
 protected:
  static Isolation isolation(const Lab& lab, context::Backend backend) {
    return {.seconds = 240,  // softpipe is a hundred times slower
            .warm = {lab.start()},
            .width = lab.width,
            .height = lab.height,
            .backend = backend,
            .program = SHADOWLAB_PROGRAM};
  }

  static void expect_all_marks(const Lab& lab, const Reference& reference, Worker& worker) {
    const DrawSubmission by_worker = [&](const Job& job, const auto& each) {
      Job patient = job;
      patient.limits.seconds = 240;
      const Outcome outcome = worker.draw(patient, each);
      return Drawn{std::string(name_of(outcome.verdict)), outcome.sentence, {}};
    };
    std::vector<fs::path> right{lab.solution()};
    if (all_labs() && !is_another_driver())
      right.insert(right.end(), lab.alternatives.begin(), lab.alternatives.end());
    for (const fs::path& recipe : right) {
      const Result result = grade(lab, reference, {recipe.stem(), recipe, {}, {}}, by_worker, {});
      EXPECT_EQ(result.score, lab.points) << lab.name << " " << recipe.filename() << result.error;
      for (const CaseResult& one : result.cases) {
        EXPECT_EQ(one.status, Status::passed)
            << one.name << ": " << one.differing << " pixels of the " << one.compared
            << " differ, of them forgiven " << one.forgiven << ", allowed " << one.budget;
      }
    }
  }
};

TEST_F(Alarms, a_solution_has_all_marks_under_each_setting_and_against_a_reference_under_it) {
  for (const fs::path& folder : labs()) {
    Lab lab = load_lab(folder);
    lab.mistakes.clear();  // nobody asks for hints
    gl::Graphics graphics(context::create(setting->context), lab.width, lab.height);
    const Reference reference = draw_reference(graphics, lab);
    {
      Worker alike(isolation(lab, setting->context));
      expect_all_marks(lab, reference, alike);
    }
    if (is_another_driver() && lab.name == "12_pcf") continue;
    const std::string variable(setting->variable), value(setting->value);
    if (!variable.empty()) ::unsetenv(variable.c_str());
    {
      Worker usual(isolation(lab, context::Backend::automatic));
      expect_all_marks(lab, reference, usual);
    }
    if (!variable.empty()) ::setenv(variable.c_str(), value.c_str(), 1);
  }
}

}  // namespace
}  // namespace shadowlab::lab

int main(int argc, char** argv) {
  using namespace shadowlab::lab;
  testing::InitGoogleTest(&argc, argv);
  const std::string_view name = argc > 1 ? argv[1] : "";
  const auto* found = std::find_if(settings.begin(), settings.end(),
                                   [&](const DriverSetting& one) { return one.name == name; });
  if (found == settings.end()) return 2;
  setting = found;
  // Before a driver is there to read it.
  if (!setting->variable.empty())
    ::setenv(std::string(setting->variable).c_str(), std::string(setting->value).c_str(), 1);
  return RUN_ALL_TESTS();
}
