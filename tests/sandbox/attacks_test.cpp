// Every attack of attacks/*.lua ends in its time, with its verdict, in a plain sentence, and the
// next honest submission is drawn as ever. An attack is a recipe, and its first comments say:
//
//   -- what it tries
//   -- expect: VERDICT or VERDICT …     as lab::name_of names them
//   -- says: a part of the sentence     (optional)
//   -- script: S s                      of the script's clock; ample unless given
//   -- job: S s                         of the job's clock, the one on the wall; as ample
//   -- memory: N MiB                    of Lua, 64 unless given
//
// A clock is given only to an attack that nothing else would end. All others end by themselves,
// however slow the machine is that they run on.
#include <gmock/gmock.h>

#include <map>
#include <memory>

#include "honest.h"

namespace shadowlab::sandbox_tests {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

// The value of "-- KEY: value", or "".
std::string field(const std::string& text, const std::string& key) {
  const std::string mark = "-- " + key + ": ";
  const auto at = text.find(mark);
  if (at == std::string::npos) return "";
  return text.substr(at + mark.size(), text.find('\n', at) - at - mark.size());
}

// The seconds of one of its clocks.
double seconds_of(const std::string& attack, const std::string& which) {
  const std::string given = field(attack, which);
  return given.empty() ? ample : std::stod(given);
}

std::vector<fs::path> attacks() {
  std::vector<fs::path> files;
  for (const auto& entry :
       fs::directory_iterator(fs::path(SHADOWLAB_TESTS_DIR) / "sandbox" / "attacks"))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

// Workers are kept from attack to attack, by the seconds of a job: what one attack left behind the
// next would meet.
lab::Worker& worker_for(double seconds) {
  static std::map<double, std::unique_ptr<lab::Worker>> workers;
  auto& worker = workers[seconds];
  if (!worker) {
    lab::Isolation limits = isolation();
    limits.seconds = seconds;
    limits.memory = std::size_t{1} << 29;
    worker = std::make_unique<lab::Worker>(limits);
  }
  return *worker;
}

class Attack : public InFolder, public testing::WithParamInterface<fs::path> {};

void expect_plain(const std::string& sentence) {
  EXPECT_THAT(sentence, Not(HasSubstr("\n")));
  EXPECT_THAT(sentence, Not(HasSubstr("\x1b")));
  EXPECT_THAT(sentence, Not(HasSubstr("root:")));
  EXPECT_LE(sentence.size(), 1200u);
  for (const char* word : {"std::", "terminate", "what():", "exception", "bad_alloc", "nullptr"})
    EXPECT_THAT(sentence, Not(HasSubstr(word)));
}

TEST_P(Attack, ends_in_its_time_with_its_verdict_and_harms_nobody) {
  std::ifstream file(GetParam(), std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const std::string memory = field(text, "memory");
  const double seconds = seconds_of(text, "job") * slowness;
  lab::Worker& worker = worker_for(seconds);

  lab::Job job{.recipe = GetParam(), .width = 16, .height = 8};
  job.shots.resize(2);
  job.limits.seconds = seconds_of(text, "script");
  job.limits.memory = std::size_t{memory.empty() ? 64 : std::stoul(memory)} << 20;
  const lab::Outcome outcome = worker.draw(job);

  const std::string got(lab::name_of(outcome.verdict));
  EXPECT_THAT(" or " + field(text, "expect") + " or ", HasSubstr(" or " + got + " or "))
      << outcome.sentence << outcome.err;
  EXPECT_THAT(outcome.sentence, HasSubstr(field(text, "says")));
  EXPECT_EQ(outcome.sentence.empty(), outcome.verdict == lab::Verdict::finished);
  expect_plain(outcome.sentence);
  if (outcome.verdict == lab::Verdict::timed_out) {
    EXPECT_GE(outcome.seconds, seconds);
  }
  EXPECT_LT(outcome.seconds, ample * slowness);
  expect_honest(worker.draw(honest()));
}

INSTANTIATE_TEST_SUITE_P(Lua, Attack, testing::ValuesIn(attacks()),
                         [](const auto& attack) { return attack.param.stem().string(); });

}  // namespace
}  // namespace shadowlab::sandbox_tests
