// Lua's patterns, matched within a budget.
//
// The language is the one of the Lua 5.4 manual, section 6.4.1. A pattern is compiled to a list of
// items that follow each other; only an item that matches a single character can repeat. So a match
// is a walk along the list, and the way back is a list of the repeated items that may still take
// another length: no recursion, and never more such choices than items. The number of steps can
// still be exponential in the number of items, which is why they are counted.
#pragma once

#include <bitset>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

namespace shadowlab::lua {

/// Receives the steps done since the last call; throws to stop the match.
using SpendSteps = std::function<void(std::uint64_t)>;

class Pattern {
 public:
  enum class Caret {
    anchors,  ///< at the beginning of the pattern, it ties the match to where the search begins
    literal,  ///< is a character like others, as in gmatch
  };

  /// Throws InputError for a malformed pattern.
  explicit Pattern(std::string_view text, Caret caret = Caret::anchors);

  /// Whether `text` has no character with a meaning of its own.
  static bool is_plain(std::string_view text);

  struct Capture {
    std::size_t begin = 0;
    std::size_t end = 0;
    bool is_position = false;  ///< "()": its value is begin + 1, as an integer
  };
  struct Match {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::vector<Capture> captures;
  };

  bool anchored() const { return anchored_; }
  std::size_t capture_count() const { return capture_count_; }

  /// The match that begins exactly at `at`.
  bool match_at(std::string_view subject, std::size_t at, const SpendSteps& spend,
                Match& match) const;
  /// The first match that begins at `from` or, unless anchored, later.
  bool find(std::string_view subject, std::size_t from, const SpendSteps& spend,
            Match& match) const;

 private:
  using Set = std::bitset<256>;
  enum class Kind : std::uint8_t {
    literal,
    any,
    set,  // a single character
    open,
    position,
    close,  // captures
    same,
    balance,
    frontier,
    end  // %1, %bxy, %f[set], $
  };
  enum class Times : std::uint8_t { once, any_greedy, some_greedy, any_lazy, optional };
  struct Item {
    Kind kind;
    Times times = Times::once;
    unsigned char first = 0;   // the literal; %bxy: x
    unsigned char second = 0;  // %bxy: y
    std::uint32_t index = 0;   // of the set, or of the capture
  };
  struct Choice;
  class Compiler;
  class Walk;

  std::vector<Item> items_;
  std::vector<Set> sets_;
  std::size_t capture_count_ = 0;
  bool anchored_ = false;
};

}  // namespace shadowlab::lua
