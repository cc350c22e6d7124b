// Mutants of the labs' solutions: each constant, number, switch and call of GL changed or left out,
// one at a time. A mutant dies when it loses marks. One that draws what the solution draws, to the
// last bit and in the cases of other seeds too, is no mutant but another way to write the same.
// What remains lives: it shows what the lab's cases do not see.
//
//   bench_mutants [LAB…]     kill rate of each lab, and the mutants that live with their lines
#include <fmt/format.h>
#include <unistd.h>

#include <cctype>
#include <deque>

#include "lab/text_file.h"
#include "mutation.h"

namespace shadowlab::lab {
namespace {

struct Mutant {
  int line;
  std::string what, source;
};

bool in_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// The source with its comments and quoted texts blanked: what may be changed, at the same places.
std::string changeable(std::string source) {
  char quote = 0;
  for (std::size_t i = 0; i < source.size(); ++i) {
    if (quote == 0 && source.compare(i, 2, "--") == 0) {
      while (i < source.size() && source[i] != '\n') source[i++] = ' ';
    } else if (quote == 0 && (source[i] == '"' || source[i] == '\'')) {
      quote = source[i];
    } else if (quote != 0 && (source[i] == quote || source[i] == '\n')) {
      quote = 0;
    } else if (quote != 0) {
      source[i] = ' ';
    }
  }
  return source;
}

class Mutants {
 public:
  explicit Mutants(std::string source) : source_(std::move(source)), text_(changeable(source_)) {
    // What is before is the recipe's table: titles, parameters and their defaults.
    at_ = std::min(text_.find("function recipe."), text_.size());
    while (at_ < text_.size()) step();
    omit_calls();
  }
  std::vector<Mutant> all;

 private:
  void step() {
    if (!in_name(text_[at_])) {
      ++at_;
      return;
    }
    const std::size_t begin = at_;
    while (at_ < text_.size() && (in_name(text_[at_]) || (text_[at_] == '.' && number_at(begin))))
      ++at_;
    const std::string word = text_.substr(begin, at_ - begin);
    if (number_at(begin)) return number(begin, word);
    if (word == "true") return add(begin, word, "false");
    if (word == "false") return add(begin, word, "true");
    for (const auto& family : families) {
      const auto found = std::find(family.begin(), family.end(), word);
      if (found == family.end()) continue;
      for (const std::string_view other : family) {
        if (other != word) add(begin, word, std::string(other));
      }
      return;
    }
  }

  bool number_at(std::size_t at) const {
    return std::isdigit(static_cast<unsigned char>(text_[at])) != 0;
  }

  void number(std::size_t at, const std::string& word) {
    if (word.starts_with("0x")) return add(at, word, "0x0");
    const double value = std::strtod(word.c_str(), nullptr);
    const bool whole = word.find('.') == std::string::npos;
    add(at, word,
        whole ? fmt::format("{}", static_cast<long>(value) + 1)
              : fmt::format("{}", value * 1.5 + 0.1));
    if (value != 0) add(at, word, whole ? "0" : "0.0");
  }

  void add(std::size_t at, const std::string& old, const std::string& by) {
    std::string source = source_;
    source.replace(at, old.size(), by);
    all.push_back({line_of(at), fmt::format("{} → {}", old, by), std::move(source)});
  }

  int line_of(std::size_t at) const {
    return 1 + static_cast<int>(std::count(
                   source_.begin(), source_.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
  }

  // Lines that are one whole call of GL.
  void omit_calls() {
    for (std::size_t begin = 0; begin < text_.size();) {
      const std::size_t end = std::min(text_.find('\n', begin), text_.size());
      std::string line = text_.substr(begin, end - begin);
      const auto first = line.find_first_not_of(' ');
      const auto last = line.find_last_not_of(' ');
      if (first != std::string::npos && line.compare(first, 3, "gl.") == 0 && line[last] == ')') {
        std::string source = source_;
        source.replace(begin, end - begin, "");
        all.push_back(
            {line_of(begin), "without " + line.substr(first, last + 1 - first), std::move(source)});
      }
      begin = end + 1;
    }
  }

  std::string source_, text_;
  std::size_t at_ = 0;
};

Counts run(const fs::path& folder) {
  std::deque<Exam> exams;
  exams.emplace_back(folder, std::nullopt);
  for (const std::uint64_t seed : {1, 2, 3}) exams.emplace_back(folder, seed);
  const Lab& lab = exams.front().lab();
  const fs::path file =
      fs::temp_directory_path() / fmt::format("shadowlab-mutant-{}.lua", ::getpid());
  Counts counts;
  std::string alive;
  for (const Mutant& mutant : Mutants(read_text(lab.solution())).all) {
    write_text(file, mutant.source);
    ++counts.all;
    Distance distance;
    if (!exams.front().passes(file, distance)) {
      ++counts.dead;
      continue;
    }
    int others = 0;  // seeds with which it would have died
    for (std::size_t i = 1; i < exams.size(); ++i) others += !exams[i].passes(file, distance);
    counts.same += distance.pixels == 0;
    if (distance.pixels == 0) continue;
    alive += fmt::format(
        "  solution.lua:{}: {} ({} pixels, by {} at most; dies with {} of 3 other seeds)\n",
        mutant.line, mutant.what, distance.pixels, distance.most, others);
  }
  fs::remove(file);
  fmt::print("{:<28} {}\n{}", lab.name, counts.text(), alive);
  std::fflush(stdout);
  return counts;
}

}  // namespace
}  // namespace shadowlab::lab

int main(int argc, char** argv) {
  return shadowlab::lab::over_labs(argc, argv, shadowlab::lab::run);
}
