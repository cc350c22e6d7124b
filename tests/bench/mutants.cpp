// Mutants of the labs' solutions: each constant, number, switch and call of GL changed or left out,
// one at a time. A mutant dies when it loses marks; one that lives either draws the same pictures
// or shows what the lab's cases do not see.
//
//   bench_mutants [LAB…]     kill rate of each lab, and the mutants that live with their lines
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <set>

#include "core/version.h"
#include "lab/grade.h"
#include "lab/text_file.h"

namespace shadowlab::lab {
namespace {

namespace fs = std::filesystem;

// What is easily taken for one another.
const std::vector<std::vector<std::string_view>> families{
    {"NEVER", "LESS", "EQUAL", "LEQUAL", "GREATER", "NOTEQUAL", "GEQUAL", "ALWAYS"},
    {"KEEP", "ZERO", "REPLACE", "INCR_WRAP", "DECR_WRAP", "INVERT", "INCR", "DECR"},
    {"FRONT", "BACK"},
    {"ONE", "SRC_ALPHA", "ONE_MINUS_SRC_ALPHA", "DST_COLOR"},
    {"COLOR_BUFFER_BIT", "DEPTH_BUFFER_BIT", "STENCIL_BUFFER_BIT"},
    {"DEPTH_TEST", "STENCIL_TEST", "CULL_FACE", "BLEND", "POLYGON_OFFSET_FILL"},
    {"NEAREST", "LINEAR"},
    {"CLAMP_TO_EDGE", "REPEAT", "CLAMP_TO_BORDER"},
    {"ACCUM", "LOAD", "ADD", "MULT", "RETURN"},
    {"CW", "CCW"},
};

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

struct Counts {
  std::size_t all = 0, dead = 0;
};

Counts run(const fs::path& folder) {
  const Lab lab = load_lab(folder);
  gl::Graphics graphics(context::create(), lab.width, lab.height);
  Reference reference = draw_reference(graphics, lab);
  reference.mistakes.clear();  // nobody reads the hints here
  const DrawSubmission in_process = [&](const Job& job, const auto& each) {
    draw(graphics, job, each);
    return Drawn{};
  };
  const fs::path file = fs::temp_directory_path() / "shadowlab-mutant.lua";
  Counts counts;
  std::string alive;
  for (const Mutant& mutant : Mutants(read_text(lab.solution())).all) {
    write_text(file, mutant.source);
    const Result result = grade(lab, reference, {"mutant", file, {}, {}}, in_process, {});
    ++counts.all;
    if (!result.passed()) {
      ++counts.dead;
    } else {
      alive += fmt::format("  solution.lua:{}: {}\n", mutant.line, mutant.what);
    }
  }
  fs::remove(file);
  fmt::print("{:<28} {:>4} of {:>4} die, {:.1f} %\n{}", lab.name, counts.dead, counts.all,
             100.0 * static_cast<double>(counts.dead) / static_cast<double>(counts.all), alive);
  std::fflush(stdout);
  return counts;
}

}  // namespace
}  // namespace shadowlab::lab

int main(int argc, char** argv) {
  using namespace shadowlab;
  std::set<std::filesystem::path> labs;
  for (int i = 1; i < argc; ++i) labs.insert(home() / "labs" / argv[i]);
  if (labs.empty()) {
    for (const auto& entry : std::filesystem::directory_iterator(home() / "labs")) {
      if (exists(entry.path() / "lab.lua")) labs.insert(entry.path());
    }
  }
  lab::Counts sum;
  for (const auto& folder : labs) {
    const auto counts = lab::run(folder);
    sum.all += counts.all;
    sum.dead += counts.dead;
  }
  fmt::print("{:<28} {:>4} of {:>4} die\n", "all", sum.dead, sum.all);
}
