// Matching: the walk along the items of a pattern.
#include <utility>

#include "lua/pattern.h"

namespace shadowlab::lua {
namespace {

constexpr std::uint64_t steps_between_payments = 1024;

unsigned char byte(char c) { return static_cast<unsigned char>(c); }

}  // namespace

// A repeated item that may take another length: from `low` up to below `high` for a greedy one,
// which has tried `high`; a lazy one has tried `low` and may grow.
struct Pattern::Choice {
  std::size_t item;
  std::size_t low;
  std::size_t high;
};

// One attempt to match, from one place of the subject.
class Pattern::Walk {
 public:
  Walk(const Pattern& pattern, std::string_view subject, const SpendSteps& spend, Match& match)
      : pattern_(pattern), subject_(subject), spend_(spend), match_(match) {}

  bool from(std::size_t begin) {
    at_ = begin;
    item_ = 0;
    choices_.clear();
    while (item_ < pattern_.items_.size()) {
      count(1);
      if (!advance(pattern_.items_[item_]) && !go_back()) return false;
    }
    match_.begin = begin;
    match_.end = at_;
    return true;
  }

  void pay() {
    if (steps_ > 0) spend_(std::exchange(steps_, 0));
  }

 private:
  void count(std::uint64_t steps) {
    steps_ += steps;
    if (steps_ >= steps_between_payments) pay();
  }

  bool fits(const Item& item, std::size_t at) const {
    if (at >= subject_.size()) return false;
    const unsigned char c = byte(subject_[at]);
    if (item.kind == Kind::literal) return c == item.first;
    return item.kind == Kind::any || pattern_.sets_[item.index][c];
  }

  // Matches the item at the current place and moves behind both, or gives false.
  bool advance(const Item& item) {
    switch (item.kind) {
      case Kind::literal:
      case Kind::any:
      case Kind::set:
        return advance_single(item);
      case Kind::open:
        match_.captures[item.index].begin = at_;
        break;
      case Kind::close:
        match_.captures[item.index].end = at_;
        break;
      case Kind::position:
        match_.captures[item.index] = {at_, at_, true};
        break;
      case Kind::end:
        if (at_ != subject_.size()) return false;
        break;
      case Kind::same:
        if (!advance_same(match_.captures[item.index])) return false;
        break;
      case Kind::balance:
        if (!advance_balance(item)) return false;
        break;
      case Kind::frontier: {
        // The subject begins and ends with '\0' as it were.
        const Set& set = pattern_.sets_[item.index];
        const unsigned char before = at_ > 0 ? byte(subject_[at_ - 1]) : 0;
        const unsigned char here = at_ < subject_.size() ? byte(subject_[at_]) : 0;
        if (set[before] || !set[here]) return false;
        break;
      }
    }
    ++item_;
    return true;
  }

  bool advance_single(const Item& item) {
    switch (item.times) {
      case Times::once:
        if (!fits(item, at_)) return false;
        ++at_;
        break;
      case Times::any_lazy:
        choices_.push_back({item_, at_, at_});
        break;
      default: {
        const std::size_t least = at_ + (item.times == Times::some_greedy ? 1 : 0);
        const std::size_t most = item.times == Times::optional ? at_ + 1 : subject_.size();
        std::size_t end = at_;
        while (end < most && fits(item, end)) ++end;
        count(end - at_);
        if (end < least) return false;
        if (end > least) choices_.push_back({item_, least, end});
        at_ = end;
      }
    }
    ++item_;
    return true;
  }

  // Takes the latest choice that has another length to try.
  bool go_back() {
    while (!choices_.empty()) {
      Choice& choice = choices_.back();
      const Item& item = pattern_.items_[choice.item];
      item_ = choice.item + 1;
      if (item.times == Times::any_lazy) {
        if (fits(item, choice.low)) {
          at_ = ++choice.low;
          return true;
        }
        choices_.pop_back();
        continue;
      }
      at_ = --choice.high;
      if (choice.high == choice.low) choices_.pop_back();
      return true;
    }
    return false;
  }

  bool advance_same(const Capture& capture) {
    if (capture.is_position) return false;  // a place is no text to find again
    const std::size_t length = capture.end - capture.begin;
    count(length / 16);
    if (length > subject_.size() - at_) return false;
    if (subject_.substr(capture.begin, length) != subject_.substr(at_, length)) return false;
    at_ += length;
    return true;
  }

  bool advance_balance(const Item& item) {
    if (at_ >= subject_.size() || byte(subject_[at_]) != item.first) return false;
    std::size_t depth = 1;
    for (std::size_t i = at_ + 1; i < subject_.size(); ++i) {
      count(1);
      const unsigned char c = byte(subject_[i]);
      if (c == item.second) {
        if (--depth == 0) {
          at_ = i + 1;
          return true;
        }
      } else if (c == item.first) {
        ++depth;
      }
    }
    return false;
  }

  const Pattern& pattern_;
  std::string_view subject_;
  const SpendSteps& spend_;
  Match& match_;
  std::size_t item_ = 0;
  std::size_t at_ = 0;
  std::uint64_t steps_ = 0;
  std::vector<Choice> choices_;
};

bool Pattern::match_at(std::string_view subject, std::size_t at, const SpendSteps& spend,
                       Match& match) const {
  match.captures.resize(capture_count_);
  Walk walk(*this, subject, spend, match);
  const bool found = walk.from(at);
  walk.pay();
  return found;
}

bool Pattern::find(std::string_view subject, std::size_t from, const SpendSteps& spend,
                   Match& match) const {
  match.captures.resize(capture_count_);
  Walk walk(*this, subject, spend, match);
  const std::size_t last = anchored_ ? from : subject.size();
  for (std::size_t at = from; at <= last; ++at) {
    if (!walk.from(at)) continue;
    walk.pay();
    return true;
  }
  walk.pay();
  return false;
}

}  // namespace shadowlab::lua
