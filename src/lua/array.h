// Arrays that GL reads, from Lua: a table of numbers, a vector, a matrix.
#pragma once

#include <vector>

#include "lua/bind.h"
#include "lua/value.h"

namespace shadowlab::lua {

/// The numbers of a table, or of a vec2 … mat4 (column by column), at `index`; at most `most`.
/// Throws InputError for anything else, and for a number that is not finite.
std::vector<double> read_numbers(const Call& call, int index, std::size_t most);

/// The same as GL's element type; integers are checked to be integers in its range.
template <class T>
std::vector<T> read_array(const Call& call, int index, std::size_t most) {
  std::vector<T> values;
  for (const double number : read_numbers(call, index, most)) {
    if constexpr (std::is_integral_v<T>) {
      const bool fits = number == std::floor(number) &&
                        number >= double(std::numeric_limits<T>::min()) &&
                        number <= double(std::numeric_limits<T>::max());
      if (!fits) call.wrong_argument(index, "a table of integers");
    }
    values.push_back(static_cast<T>(number));
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

/// Bytes of one number of `type`.
std::size_t bytes_of_type(GLenum type);

}  // namespace shadowlab::lua
