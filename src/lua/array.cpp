#include "lua/array.h"

#include <fmt/format.h>

#include <cstring>

namespace shadowlab::lua {
namespace {

template <class T>
void append(std::vector<std::byte>& bytes, double number) {
  T value{};
  if constexpr (std::is_integral_v<T>) {
    value = static_cast<T>(static_cast<std::int64_t>(std::fmin(std::fmax(number, -9e15), 9e15)));
  } else {
    value = static_cast<T>(number);
  }
  const std::size_t at = bytes.size();
  bytes.resize(at + sizeof value);
  std::memcpy(bytes.data() + at, &value, sizeof value);
}

void append(std::vector<std::byte>& bytes, GLenum type, double number) {
  switch (type) {
    case GL_BYTE:
      return append<GLbyte>(bytes, number);
    case GL_UNSIGNED_BYTE:
      return append<GLubyte>(bytes, number);
    case GL_SHORT:
      return append<GLshort>(bytes, number);
    case GL_UNSIGNED_SHORT:
      return append<GLushort>(bytes, number);
    case GL_INT:
      return append<GLint>(bytes, number);
    case GL_FLOAT:
      return append<GLfloat>(bytes, number);
    default:
      return append<GLuint>(bytes, number);
  }
}

template <class T>
void append_value(std::vector<double>& numbers, const T* value, int components) {
  const auto* first = reinterpret_cast<const double*>(value);
  numbers.insert(numbers.end(), first, first + components);
}

}  // namespace

std::size_t bytes_of_type(GLenum type) {
  switch (type) {
    case GL_BYTE:
    case GL_UNSIGNED_BYTE:
      return 1;
    case GL_SHORT:
    case GL_UNSIGNED_SHORT:
      return 2;
    default:
      return 4;
  }
}

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
  const auto numbers = read_numbers(call, index, most_bytes / bytes_of_type(type));
  bytes.reserve(numbers.size() * bytes_of_type(type));
  for (const double number : numbers) append(bytes, type, number);
  return bytes;
}

}  // namespace shadowlab::lua
