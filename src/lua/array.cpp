#include "lua/array.h"

#include <fmt/format.h>

#include <cstring>

namespace shadowlab::lua {
namespace {

template <class T>
std::vector<std::byte> bytes_as(const Call& call, int index, std::size_t most_bytes) {
  const std::vector<T> values = read_array<T>(call, index, most_bytes / sizeof(T));
  std::vector<std::byte> bytes(values.size() * sizeof(T));
  if (!bytes.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
  return bytes;
}

template <class T>
void append_value(std::vector<double>& numbers, const T* value, int components) {
  const auto* first = reinterpret_cast<const double*>(value);
  numbers.insert(numbers.end(), first, first + components);
}

}  // namespace

std::vector<double> read_numbers(const Call& call, int index, std::size_t most) {
  lua_State* L = call.L;
  std::vector<double> numbers;
  if (const auto* v2 = test<glm::dvec2>(L, index)) {
    append_value(numbers, v2, 2);
  } else if (const auto* v3 = test<glm::dvec3>(L, index)) {
    append_value(numbers, v3, 3);
  } else if (const auto* v4 = test<glm::dvec4>(L, index)) {
    append_value(numbers, v4, 4);
  } else if (const auto* m3 = test<glm::dmat3>(L, index)) {
    append_value(numbers, m3, 9);
  } else if (const auto* m4 = test<glm::dmat4>(L, index)) {
    append_value(numbers, m4, 16);
  } else if (lua_type(L, index) == LUA_TTABLE) {
    const std::size_t count = lua_rawlen(L, index);
    if (count > most) {
      call.wrong_argument(index,
                          fmt::format("a table of at most {} numbers (it has {})", most, count));
    }
    call.stage.state.check_budget(count);
    numbers.reserve(count);
    for (std::size_t i = 1; i <= count; ++i) {
      if (lua_rawgeti(L, index, static_cast<lua_Integer>(i)) != LUA_TNUMBER) {
        lua_pop(L, 1);
        call.wrong_argument(index, "a table of numbers");
      }
      numbers.push_back(lua_tonumber(L, -1));
      lua_pop(L, 1);
    }
  } else {
    call.wrong_argument(index, "a table of numbers");
  }
  if (numbers.size() > most) call.wrong_argument(index, fmt::format("at most {} numbers", most));
  for (const double number : numbers) {
    if (!std::isfinite(number)) call.wrong_argument(index, "finite numbers");
  }
  return numbers;
}

std::vector<std::byte> read_bytes(const Call& call, int index, GLenum type,
                                  std::size_t most_bytes) {
  lua_State* L = call.L;
  std::vector<std::byte> bytes;
  if (lua_isnoneornil(L, index)) return bytes;
  if (lua_type(L, index) == LUA_TSTRING) {
    std::size_t length = 0;
    const char* text = lua_tolstring(L, index, &length);
    if (length > most_bytes)
      call.wrong_argument(index, fmt::format("at most {} bytes", most_bytes));
    bytes.resize(length);
    if (length > 0) std::memcpy(bytes.data(), text, length);
    return bytes;
  }
  switch (type) {
    case GL_BYTE:
      return bytes_as<GLbyte>(call, index, most_bytes);
    case GL_UNSIGNED_BYTE:
      return bytes_as<GLubyte>(call, index, most_bytes);
    case GL_SHORT:
      return bytes_as<GLshort>(call, index, most_bytes);
    case GL_UNSIGNED_SHORT:
      return bytes_as<GLushort>(call, index, most_bytes);
    case GL_INT:
      return bytes_as<GLint>(call, index, most_bytes);
    case GL_FLOAT:
      return bytes_as<GLfloat>(call, index, most_bytes);
    default:
      return bytes_as<GLuint>(call, index, most_bytes);
  }
}

void refuse_element(const Call& call, int index, std::size_t element, double number, double least,
                    double most) {
  const bool floats = most > 1e30;
  call.refuse(fmt::format("element {} of argument {} is {}, which is not {}", element + 1, index,
                          number,
                          floats ? std::string("a finite float")
                                 : fmt::format("an integer from {:.0f} to {:.0f}", least, most)));
}

}  // namespace shadowlab::lua
