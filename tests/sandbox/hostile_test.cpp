// Submissions that got out of Lua and own their process: the system refuses what they ask for, the
// grader survives what they send, and each ends with a verdict in a plain sentence; with namespaces
// and without.
#include "hostile.h"

#include <gmock/gmock.h>

#include "honest.h"

namespace shadowlab::sandbox_tests {
namespace {

using lab::Verdict;
using testing::HasSubstr;
using testing::Not;

// A process that only reports how its attack went ends with `crashed` and these words on its
// standard error.
constexpr const char* refused = "it was refused";

struct Case {
  const char* attack;
  std::initializer_list<Verdict> verdicts;
  const char* words = "";
};

constexpr auto forbidden = Verdict::forbidden, crashed = Verdict::crashed,
               garbled = Verdict::garbled, timed_out = Verdict::timed_out;

const Case cases[] = {{"forks", {forbidden}},
                      {"forks_by_hand", {forbidden}},
                      {"forks_by_clone3", {crashed}, refused},
                      {"starts_a_thread", {crashed}, refused},
                      {"runs_a_program", {forbidden}},
                      {"kills_its_parent", {forbidden}},
                      {"kills_everybody", {forbidden}},
                      {"signals_a_thread_of_another", {forbidden}},
                      {"traces_its_parent", {forbidden}},
                      {"reads_its_parents_memory", {forbidden}},
                      {"opens_a_socket", {forbidden}},
                      {"opens_a_local_socket", {forbidden}},
                      {"makes_namespaces", {forbidden}},
                      {"mounts", {forbidden}},
                      {"sets_up_io_uring", {forbidden}},
                      {"loads_bpf", {forbidden}},
                      {"watches_counters", {forbidden}},
                      {"shares_memory", {forbidden}},
                      {"takes_another_user", {forbidden}},
                      {"keeps_keys", {forbidden}},
                      {"writes_a_file", {crashed}, refused},
                      {"writes_in_tmp", {crashed}, refused},
                      {"writes_over_its_recipe", {crashed}, refused},
                      {"makes_a_nameless_file", {crashed}, refused},
                      {"makes_a_folder", {forbidden}},
                      {"removes_its_recipe", {forbidden}},
                      {"makes_a_link", {forbidden}},
                      {"reads_passwd", {crashed}, refused},
                      {"reads_its_parents_environment", {crashed}, refused},
                      {"lists_the_submissions", {crashed}, refused},
                      {"raises_its_limits", {crashed}, refused},
                      {"sends_noise", {garbled}},
                      {"sends_a_job", {garbled}},
                      {"sends_a_length_of_2_to_63", {Verdict::flooded}},
                      {"sends_another_size", {garbled}},
                      {"sends_a_shot_twice", {garbled}},
                      {"says_done_at_once", {garbled}},
                      {"goes_on_after_the_end", {garbled}},
                      {"sends_half_a_message", {garbled}},
                      {"pours_into_the_channel", {Verdict::flooded}},
                      {"pours_onto_standard_output", {Verdict::flooded}},
                      {"pours_onto_standard_error", {Verdict::flooded}},
                      {"ends_without_a_word", {garbled}},
                      {"breaks_down", {crashed}},
                      {"aborts", {crashed}},
                      {"kills_itself", {Verdict::out_of_memory, forbidden}},
                      {"overflows_its_stack", {crashed}},
                      {"takes_all_memory", {Verdict::out_of_memory}},
                      {"closes_all_and_spins", {timed_out}},
                      {"sleeps", {timed_out}},
                      {"ignores_all_signals", {timed_out}}};

using Namespaces = lab::Isolation::Namespaces;

// The clock is for those that nothing else would end; the others end by themselves, however slow
// the machine is.
double seconds_of(const Case& attack) {
  return std::ranges::equal(attack.verdicts, std::array{timed_out}) ? 1 : ample;
}

lab::Worker& worker(Namespaces namespaces, double seconds) {
  static std::map<std::pair<Namespaces, double>, std::unique_ptr<lab::Worker>> workers;
  auto& made = workers[{namespaces, seconds}];
  if (!made) {
    lab::Isolation isolation{.seconds = seconds, .namespaces = namespaces};
    isolation.memory = std::size_t{128} << 20;
    isolation.results = std::size_t{32} << 20;
    made = std::make_unique<lab::Worker>(isolation);
  }
  return *made;
}

class Hostile : public InFolder,
                public testing::WithParamInterface<std::tuple<Namespaces, Case>> {};

TEST_P(Hostile, gets_nothing_and_harms_nobody) {
  const auto& [namespaces, attack] = GetParam();
#ifdef __SANITIZE_ADDRESS__
  // It maps more memory than any limit, and starts a program to put its words on a crash.
  if (std::string_view(attack.attack) == "takes_all_memory") GTEST_SKIP();
#endif
  lab::Job job{.recipe = write(std::string(attack.attack) + ".lua", ""), .width = 16, .height = 8};
  job.shots.resize(2);
  const double seconds = seconds_of(attack);
  lab::Worker& by = worker(namespaces, seconds);
  const lab::Layers before = by.layers();
  const std::string name = attack.attack;
  if ((name.starts_with("reads") || name.starts_with("lists")) && !before.landlock &&
      !before.namespaces)
    GTEST_SKIP() << "this machine has no layer that keeps files from being read";
  const lab::Outcome outcome = by.draw(job);
  EXPECT_THAT(attack.verdicts, testing::Contains(outcome.verdict))
      << lab::name_of(outcome.verdict) << ": " << outcome.sentence;
  if (*attack.words != '\0') {
    EXPECT_EQ(outcome.err, attack.words);
  }
  EXPECT_THAT(outcome.sentence, Not(HasSubstr("succeeded")));
  EXPECT_THAT(outcome.sentence, Not(HasSubstr("\n")));
  EXPECT_FALSE(outcome.sentence.empty());
  if (outcome.verdict == timed_out) {
    EXPECT_GE(outcome.seconds, seconds);
  }
  EXPECT_LT(outcome.seconds, ample);
  EXPECT_EQ(by.layers(), before);
}

INSTANTIATE_TEST_SUITE_P(InNamespaces, Hostile,
                         testing::Combine(testing::Values(Namespaces::where_allowed),
                                          testing::ValuesIn(cases)),
                         [](const auto& each) { return std::get<1>(each.param).attack; });
INSTANTIATE_TEST_SUITE_P(WithoutNamespaces, Hostile,
                         testing::Combine(testing::Values(Namespaces::none),
                                          testing::ValuesIn(cases)),
                         [](const auto& each) { return std::get<1>(each.param).attack; });

}  // namespace
}  // namespace shadowlab::sandbox_tests
