#include "lab/verdict.h"

#include <fmt/format.h>
#include <sys/wait.h>

#include <algorithm>
#include <csignal>
#include <cstring>

#include "lab/lock.h"

namespace shadowlab::lab {
namespace {

// For whoever gets the submission: it is none that a recipe brings about by mistake.
constexpr const char* to_whom = "; no recipe does that by mistake: show it to your instructor";

std::string time_sentence(double seconds) {
  return fmt::format(
      "the submission was still drawing after {:g} s and was stopped; look for a loop that does "
      "not "
      "end, in the script or in a shader",
      seconds);
}

std::string memory_sentence(std::size_t bytes) {
  return fmt::format(
      "the submission needed more than {} MiB of memory and was stopped; look for a table, a text "
      "or "
      "a texture that grows without end",
      bytes >> 20);
}

// Words of the process, for a sentence: their first line, and nothing that a terminal obeys.
std::string first_line(const std::string& words) {
  constexpr std::size_t longest = 200;
  std::string line = words.substr(0, std::min(words.find('\n'), longest));
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = '?';
  }
  return line.empty() ? "without a word" : line;
}

// What a child's end by a signal means.
Ruling of_signal(int signal) {
  switch (signal) {
    case SIGSYS:
      return {Verdict::forbidden,
              std::string("the submission's process asked the system for what drawing never needs, "
                          "and was stopped") +
                  to_whom};
    case SIGKILL:  // not by us: the system's own way out of a lack of memory
      return {Verdict::out_of_memory,
              "this machine ran out of memory and stopped the submission; look for a table, a text "
              "or a texture that grows without end"};
    default:
      return {Verdict::crashed, fmt::format("the submission's process broke down (signal {}, {}){}",
                                            signal, ::strsignal(signal), to_whom)};
  }
}

}  // namespace

Ruling judge(const Reception& came, const Isolation& isolation) {
  if (came.flooded)
    return {Verdict::flooded,
            std::string("the submission sent more than anybody reads, and was stopped") + to_whom};
  if (came.garbled)
    return {Verdict::garbled, fmt::format("the submission's process sent what is no drawing ({}){}",
                                          *came.garbled, to_whom)};
  if (came.lost)
    return {Verdict::crashed,
            std::string("the submission's process ended together with the one that started it") +
                to_whom};
  if (!came.ended || came.ended->timed_out)
    return {Verdict::timed_out, time_sentence(isolation.seconds)};
  const int status = came.ended->status;
  if (WIFSIGNALED(status)) return of_signal(WTERMSIG(status));
  if (WEXITSTATUS(status) == out_of_memory)
    return {Verdict::out_of_memory, memory_sentence(isolation.memory)};
  if (WEXITSTATUS(status) != 0)
    return {Verdict::crashed,
            fmt::format("the submission's process gave up ({}){}", first_line(came.err), to_whom)};
  if (!came.done)
    return {Verdict::garbled,
            std::string("the submission's process ended before all was drawn") + to_whom};
  if (came.first_error) return {Verdict::recipe_error, *came.first_error};
  return {Verdict::finished, ""};
}

std::string_view name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::finished:
      return "finished";
    case Verdict::recipe_error:
      return "recipe error";
    case Verdict::timed_out:
      return "timed out";
    case Verdict::out_of_memory:
      return "out of memory";
    case Verdict::crashed:
      return "crashed";
    case Verdict::forbidden:
      return "forbidden";
    case Verdict::flooded:
      return "flooded";
    case Verdict::garbled:
      return "garbled";
  }
  return "";
}

}  // namespace shadowlab::lab
