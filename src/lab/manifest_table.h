// The tables of a manifest, read field by field: internal to the manifest.
//
// Fields are read raw, so that no code of the manifest runs within, and what is wrong is said with
// the file, the line and what is expected.
#pragma once

#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <glm/glm.hpp>

#include "lua/state.h"

namespace shadowlab::lab {

/// Where sentences point to.
struct Source {
  std::string file, text;
  /// "FILE:LINE: ", the line where `word` first stands as a whole; "FILE: " where it does not.
  std::string place(std::string_view word) const;
};

/// A table on Lua's stack, which stays there until the whole reading ends.
class Table {
 public:
  /// The one that the file returned, on top of the stack.
  static Table returned(lua_State* L, Source source);

  lua_State* raw() const { return L_; }
  /// "points of the case "light above"".
  std::string title(std::string_view field) const;
  [[noreturn]] void refuse(std::string_view field, const std::string& expectation) const;
  /// The same, saying also what the value at `index` of the stack is.
  [[noreturn]] void refuse(std::string_view field, const std::string& expectation, int index) const;

  void expect_fields(std::initializer_list<std::string_view> names) const;
  std::optional<std::string> text(const char* field) const;
  std::string required_text(const char* field) const;
  double number(const char* field, double otherwise, double least, double most) const;
  bool flag(const char* field, bool otherwise) const;
  glm::dvec3 three(const char* field, glm::dvec3 otherwise) const;
  std::pair<int, int> size(const char* field, std::pair<int, int> otherwise, int most) const;
  std::optional<Table> table(const char* field) const;
  /// Each name of the table `field`, with its value on top of the stack.
  void each(const char* field,
            const std::function<void(const Table&, const std::string&)>& read) const;
  /// Each table of the list `field`.
  void each_of(const char* field, const std::function<void(const Table&)>& read) const;

 private:
  Table(lua_State* L, int index, std::string name, Source source)
      : L_(L), index_(index), name_(std::move(name)), source_(std::move(source)) {}
  int push(const char* field) const;
  std::string line_word(std::string_view field) const;

  lua_State* L_;
  int index_;
  std::string name_;  ///< "the lab", "the case "light above""
  std::string case_;  ///< the case's name, whose line is pointed to
  Source source_;
};

}  // namespace shadowlab::lab
