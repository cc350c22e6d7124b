#include "lua/pattern.h"

#include <algorithm>
#include <string>

#include "core/error.h"

namespace shadowlab::lua {
namespace {

constexpr std::size_t most_captures = 32;
constexpr std::size_t longest_pattern = std::size_t{64} << 10;

unsigned char byte(char c) { return static_cast<unsigned char>(c); }

bool in_range(int c, int low, int high) { return low <= c && c <= high; }

// The classes of the C locale, so that no setting of the machine matters.
bool is_in_class(int c, char letter) {
  const bool lower = in_range(c, 'a', 'z'), upper = in_range(c, 'A', 'Z');
  const bool digit = in_range(c, '0', '9'), graph = in_range(c, 33, 126);
  switch (letter) {
    case 'a':
      return lower || upper;
    case 'c':
      return c < 32 || c == 127;
    case 'd':
      return digit;
    case 'g':
      return graph;
    case 'l':
      return lower;
    case 'p':
      return graph && !lower && !upper && !digit;
    case 's':
      return c == ' ' || in_range(c, 9, 13);
    case 'u':
      return upper;
    case 'w':
      return lower || upper || digit;
    case 'x':
      return digit || in_range(c, 'a', 'f') || in_range(c, 'A', 'F');
    default:
      return false;
  }
}

// The characters that "%letter" stands for.
std::bitset<256> class_of(char letter) {
  const bool complement = in_range(letter, 'A', 'Z');
  const char lower = complement ? static_cast<char>(letter - 'A' + 'a') : letter;
  std::bitset<256> set;
  if (std::string_view("acdglpsuwx").find(lower) == std::string_view::npos) {
    set.set(byte(letter));  // "%." is "."
    return set;
  }
  for (int c = 0; c < 256; ++c) set[static_cast<std::size_t>(c)] = is_in_class(c, lower);
  return complement ? ~set : set;
}

[[noreturn]] void malformed(const std::string& reason) {
  throw InputError("malformed pattern: " + reason);
}

}  // namespace

class Pattern::Compiler {
 public:
  Compiler(Pattern& pattern, std::string_view text) : pattern_(pattern), text_(text) {}

  void compile() {
    while (at_ < text_.size()) item();
    if (!open_.empty()) malformed("a '(' has no ')'");
  }

 private:
  void item() {
    const char c = text_[at_];
    if (c == '(') return open_capture();
    if (c == ')') return close_capture();
    if (c == '$' && at_ + 1 == text_.size()) {
      ++at_;
      return add({.kind = Kind::end});
    }
    if (c == '%' && at_ + 1 < text_.size()) {
      const char next = text_[at_ + 1];
      if (next == 'b') return balance();
      if (next == 'f') return frontier();
      if (in_range(next, '0', '9')) return same_as_capture();
    }
    single();
  }

  void open_capture() {
    ++at_;
    if (pattern_.capture_count_ == most_captures) malformed("more than 32 captures");
    const auto index = static_cast<std::uint32_t>(pattern_.capture_count_++);
    if (at_ < text_.size() && text_[at_] == ')') {
      ++at_;
      return add({.kind = Kind::position, .index = index});
    }
    open_.push_back(index);
    add({.kind = Kind::open, .index = index});
  }

  void close_capture() {
    ++at_;
    if (open_.empty()) malformed("a ')' has no '('");
    add({.kind = Kind::close, .index = open_.back()});
    open_.pop_back();
  }

  void same_as_capture() {
    const int index = text_[at_ + 1] - '1';
    at_ += 2;
    const auto unsigned_index = static_cast<std::uint32_t>(index);
    if (index < 0 || unsigned_index >= pattern_.capture_count_ ||
        std::ranges::find(open_, unsigned_index) != open_.end())
      malformed("%" + std::to_string(index + 1) + " refers to no capture that is closed before it");
    add({.kind = Kind::same, .index = unsigned_index});
  }

  void balance() {
    if (at_ + 3 >= text_.size()) malformed("'%b' needs two characters after it");
    add({.kind = Kind::balance, .first = byte(text_[at_ + 2]), .second = byte(text_[at_ + 3])});
    at_ += 4;
  }

  void frontier() {
    at_ += 2;
    if (at_ >= text_.size() || text_[at_] != '[') malformed("'%f' needs a '[' after it");
    add({.kind = Kind::frontier, .index = set()});
  }

  void single() {
    const char c = text_[at_];
    Item item{.kind = Kind::literal, .first = byte(c)};
    if (c == '[') {
      item = {.kind = Kind::set, .index = set()};
    } else if (c == '%') {
      if (++at_ == text_.size()) malformed("it ends with '%'");
      const Set escaped = class_of(text_[at_]);
      if (escaped.count() == 1)
        item.first = byte(text_[at_]);
      else
        item = {.kind = Kind::set, .index = keep(escaped)};
      ++at_;
    } else {
      if (c == '.') item.kind = Kind::any;
      ++at_;
    }
    if (at_ < text_.size()) item.times = times(text_[at_]);
    if (item.times != Times::once) ++at_;
    add(item);
  }

  static Times times(char c) {
    switch (c) {
      case '*':
        return Times::any_greedy;
      case '+':
        return Times::some_greedy;
      case '-':
        return Times::any_lazy;
      case '?':
        return Times::optional;
      default:
        return Times::once;
    }
  }

  // Reads "[...]" at the current place and gives the index of its set.
  std::uint32_t set() {
    ++at_;
    const bool complement = at_ < text_.size() && text_[at_] == '^';
    if (complement) ++at_;
    const std::size_t end = end_of_set();
    Set found;
    while (at_ < end) {
      if (text_[at_] == '%') {
        found |= class_of(text_[at_ + 1]);
        at_ += 2;
      } else if (at_ + 2 < end && text_[at_ + 1] == '-') {
        for (int c = byte(text_[at_]); c <= byte(text_[at_ + 2]); ++c)
          found.set(static_cast<std::size_t>(c));
        at_ += 3;
      } else {
        found.set(byte(text_[at_++]));
      }
    }
    ++at_;
    return keep(complement ? ~found : found);
  }

  // Where the ']' is that ends the set; one in the first place is a character of the set.
  std::size_t end_of_set() const {
    std::size_t i = at_;
    do {
      if (i >= text_.size()) malformed("a '[' has no ']'");
      i += text_[i] == '%' ? 2 : 1;
    } while (i >= text_.size() || text_[i] != ']');
    return i;
  }

  std::uint32_t keep(const Set& set) {
    pattern_.sets_.push_back(set);
    return static_cast<std::uint32_t>(pattern_.sets_.size() - 1);
  }

  void add(const Item& item) { pattern_.items_.push_back(item); }

  Pattern& pattern_;
  std::string_view text_;
  std::size_t at_ = 0;
  std::vector<std::uint32_t> open_;
};

Pattern::Pattern(std::string_view text, Caret caret) {
  if (text.size() > longest_pattern) malformed("it is longer than 65,536 characters");
  if (caret == Caret::anchors && text.starts_with('^')) {
    anchored_ = true;
    text.remove_prefix(1);
  }
  items_.reserve(text.size());
  Compiler(*this, text).compile();
}

bool Pattern::is_plain(std::string_view text) {
  return text.find_first_of("^$*+?.([%-)") == std::string_view::npos;
}

}  // namespace shadowlab::lua
