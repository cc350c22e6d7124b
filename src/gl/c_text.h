// How each kind of argument is printed as C. Included by functions.cpp alone, which knows all
// kinds.
#pragma once

#include <fmt/format.h>

#include <cstring>

#include "gl/recorder.h"

namespace shadowlab::gl {
namespace c_text {

template <class T>
T read(std::uint64_t word) {
  if constexpr (std::is_floating_point_v<T>) {
    double wide;
    std::memcpy(&wide, &word, sizeof wide);
    return static_cast<T>(wide);
  } else {
    return static_cast<T>(static_cast<std::int64_t>(word));
  }
}

inline RecordedArray array_at(std::uint64_t word, std::span<const std::byte> arrays) {
  RecordedArray array;
  std::uint64_t header[2];
  std::memcpy(header, arrays.data() + word, sizeof header);
  array.count = header[0];
  array.bytes = arrays.subspan(word + sizeof header, header[1]);
  return array;
}

// A float as C writes it, shortest: 1.0f, 0.25f, 1e-05f.
inline std::string float_literal(double value, bool single) {
  std::string text =
      single ? fmt::format("{}", static_cast<float>(value)) : fmt::format("{}", value);
  if (text.find_first_of(".en") == std::string::npos) text += ".0";
  return single ? text + "f" : text;
}

template <class Kind>
std::string enum_name(GLenum value) {
  const std::string_view name = name_of<Kind>(value);
  return name.empty() ? fmt::format("0x{:04X}", value) : fmt::format("GL_{}", name);
}

// One value of a kind that is not an array.
template <class Kind>
std::string literal(std::uint64_t word) {
  if constexpr (std::is_base_of_v<EnumKind, Kind>) {
    return enum_name<Kind>(read<GLenum>(word));
  } else if constexpr (std::is_base_of_v<BitsKind, Kind>) {
    std::string text;
    for (const Constant& bit : Kind::values) {
      if (read<GLenum>(word) & bit.value)
        text += fmt::format("{}GL_{}", text.empty() ? "" : " | ", bit.name);
    }
    return text.empty() ? "0" : text;
  } else if constexpr (std::is_base_of_v<ObjectKind, Kind>) {
    const GLuint name = read<GLuint>(word);
    return name == 0 ? "0" : fmt::format("{}_{}", Kind::title, name);
  } else if constexpr (std::is_same_v<Kind, ParameterValue>) {
    // Small numbers are levels; no name of TextureParameterValue but NONE, ZERO and ONE is under
    // 256.
    return read<GLint>(word) < 256 ? fmt::format("{}", read<GLint>(word))
                                   : enum_name<TextureParameterValue>(read<GLenum>(word));
  } else if constexpr (std::is_same_v<Kind, Mask>) {
    return fmt::format("0x{:02X}", read<GLuint>(word));
  } else if constexpr (std::is_same_v<Kind, Bool>) {
    return word ? "GL_TRUE" : "GL_FALSE";
  } else if constexpr (std::is_same_v<Kind, Float>) {
    return float_literal(read<double>(word), true);
  } else if constexpr (std::is_same_v<Kind, Double>) {
    return float_literal(read<double>(word), false);
  } else if constexpr (std::is_same_v<Kind, Offset>) {
    return fmt::format("(void*){}", read<std::int64_t>(word));
  } else {
    return fmt::format("{}", read<std::int64_t>(word));
  }
}

template <class Kind>
constexpr const char* c_type = "GLint";
template <>
constexpr const char* c_type<Float> = "GLfloat";
template <>
constexpr const char* c_type<Uint> = "GLuint";
template <>
constexpr const char* c_type<ColorBuffer> = "GLenum";
template <class Kind>
requires std::is_base_of_v<ObjectKind, Kind>
constexpr const char* c_type<Kind> = "GLuint";

template <class Kind>
std::string element(std::span<const std::byte> bytes, std::size_t index) {
  RawOf<Kind> value;
  std::memcpy(&value, bytes.data() + index * sizeof value, sizeof value);
  std::uint64_t word;
  if constexpr (std::is_floating_point_v<RawOf<Kind>>) {
    const double wide = value;
    std::memcpy(&word, &wide, sizeof word);
  } else {
    word = static_cast<std::uint64_t>(static_cast<std::int64_t>(value));
  }
  return literal<Kind>(word);
}

template <class Kind>
std::string list(const RecordedArray& array) {
  if (array.bytes.empty()) return "NULL";
  std::string text;
  const std::size_t kept = array.bytes.size() / sizeof(RawOf<Kind>);
  for (std::size_t i = 0; i < kept; ++i) text += (i ? ", " : "") + element<Kind>(array.bytes, i);
  if (kept < array.count) text += fmt::format(" /* … {} in all */", array.count);
  return fmt::format("(const {}[]){{{}}}", c_type<Kind>, text);
}

}  // namespace c_text

template <class Kind>
std::string as_c(std::uint64_t word, std::span<const std::byte> arrays) {
  using namespace c_text;
  if constexpr (std::is_same_v<Kind, Text>) {
    const RecordedArray text = array_at(word, arrays);
    const std::string_view kept(reinterpret_cast<const char*>(text.bytes.data()),
                                text.bytes.size());
    return '"' + escaped(kept) + (kept.size() < text.count ? "…\"" : "\"");
  } else if constexpr (std::is_same_v<Kind, In<Text>>) {
    return "&source";
  } else if constexpr (std::is_same_v<Kind, Bytes>) {
    const RecordedArray bytes = array_at(word, arrays);
    return bytes.count == 0 ? "NULL" : fmt::format("data /* {} bytes */", bytes.count);
  } else if constexpr (std::is_same_v<Kind, OutBytes>) {
    return "pixels";
  } else if constexpr (!std::is_void_v<typename ElementOf<Kind>::Type>) {
    using Element = typename ElementOf<Kind>::Type;
    const RecordedArray array = array_at(word, arrays);
    if constexpr (std::is_same_v<Kind, Out<Element>>) {
      // What GL wrote: the names of new objects say most; of other results, where they go.
      if constexpr (std::is_base_of_v<ObjectKind, Element>) {
        if (array.count == 1) return "&" + element<Element>(array.bytes, 0);
        return list<Element>(array);
      } else {
        return array.count == 0 ? "NULL" : "result";
      }
    } else {
      return list<Element>(array);
    }
  } else {
    return literal<Kind>(word);
  }
}

}  // namespace shadowlab::gl
