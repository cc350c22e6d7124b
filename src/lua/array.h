// Arrays that GL reads, from Lua: a table of numbers, a vector, a matrix.
#pragma once

#include <vector>

#include "lua/bind.h"
#include "lua/value.h"

namespace shadowlab::lua {

/// The numbers of a table, or of a vec2 … mat4 (column by column), at `index`; at most `most`.
/// Throws InputError for anything else, and for a number that is not finite.
std::vector<double> read_numbers(const Call& call, int index, std::size_t most);

/// Throws InputError: element `element` (0-based) does not fit into what is asked for.
[[noreturn]] void refuse_element(const Call& call, int index, std::size_t element, double number,
                                 double least, double most);

/// The same as GL's element type; integers are checked to be integers, and all in its range.
template <class T>
std::vector<T> read_array(const Call& call, int index, std::size_t most) {
  constexpr auto least = static_cast<double>(std::numeric_limits<T>::lowest());
  constexpr auto largest = static_cast<double>(std::numeric_limits<T>::max());
  const std::vector<double> numbers = read_numbers(call, index, most);
  std::vector<T> values(numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const double number = numbers[i];
    const bool whole = std::is_floating_point_v<T> || number == std::floor(number);
    if (!whole || !(number >= least && number <= largest)) [[unlikely]]
      refuse_element(call, index, i, number, least, largest);
    values[i] = static_cast<T>(number);
  }
  return values;
}

/// Exactly `count` elements.
template <class T>
std::vector<T> read_array_of(const Call& call, int index, std::size_t count) {
  auto values = read_array<T>(call, index, count);
  if (values.size() != count)
    call.wrong_argument(index, "a table of " + std::to_string(count) + " numbers");
  return values;
}

/// An argument of bytes for GL: nil (none), or a table of numbers stored as `type` (GL_FLOAT …), or
/// a string of raw bytes.
std::vector<std::byte> read_bytes(const Call& call, int index, GLenum type, std::size_t most_bytes);

}  // namespace shadowlab::lua
