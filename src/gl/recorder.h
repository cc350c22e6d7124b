// What a recipe asked of GL, call by call and pass by pass: the trace.
//
// The recorder is off by default; a function of the table then pays for one comparison. On, a call
// is a few words in a vector; text is made only when somebody reads it.
#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gl/kinds.h"

namespace shadowlab::gl {

/// `text` as it stands between the quotes of a C string: other bytes than printable ASCII as octal
/// escapes.
std::string escaped(std::string_view text);

/// One recorded call, as the C that a lecture would print.
struct TracedCall {
  std::string_view function;           ///< "glStencilFunc"
  std::vector<std::string> arguments;  ///< "GL_ALWAYS", "1", "0xFF"
  std::string comment;                 ///< what the call is about, or empty
  int pass;                            ///< index into passes(), -1 outside of any

  /// glStencilFunc(GL_ALWAYS, 1, 0xFF);
  std::string as_c() const;
};

class Recorder {
 public:
  /// How many calls one trace holds; a frame that makes more is in error.
  static constexpr std::size_t most_calls = std::size_t{1} << 20;

  void begin_pass(std::string name);
  void end_pass() { pass_ = -1; }
  std::span<const std::string> passes() const { return passes_; }

  /// Forgets all calls and passes, keeping the memory for the next frame.
  void clear();

  template <class... Kinds>
  void record(std::uint16_t function, const CppOf<Kinds>&... arguments) {
    if (calls_.size() >= most_calls) [[unlikely]]
      refuse();
    calls_.push_back({function, pass_, static_cast<std::uint32_t>(words_.size()), -1});
    (words_.push_back(encode<Kinds>(arguments)), ...);
  }

  /// A remark on the last recorded call: the uniform's name, the mesh that is drawn.
  void comment(std::string_view text);

  std::size_t size() const { return calls_.size(); }
  TracedCall call(std::size_t index) const;

 private:
  struct Call {
    std::uint16_t function;
    std::int32_t pass;
    std::uint32_t first_word;
    std::int32_t comment;
  };

  template <class Kind>
  std::uint64_t encode(const CppOf<Kind>& value);
  [[noreturn]] static void refuse();
  std::uint64_t keep(const void* data, std::size_t bytes, std::size_t count);

  std::vector<Call> calls_;
  std::vector<std::uint64_t> words_;
  std::vector<std::byte> arrays_;  ///< each: its count as 8 bytes, then its elements
  std::vector<std::string> comments_;
  std::vector<std::string> passes_;
  int pass_ = -1;
};

/// An argument that was an array, back from the recorder's bytes; at most `kept` of its `count`
/// elements were kept.
struct RecordedArray {
  std::size_t count = 0;
  std::span<const std::byte> bytes;
};

/// How one kind is printed in C; `word` is what Recorder::encode made.
template <class Kind>
std::string as_c(std::uint64_t word, std::span<const std::byte> arrays);

template <class Kind>
struct ElementOf {
  using Type = void;
};
template <class Kind>
struct ElementOf<In<Kind>> {
  using Type = Kind;
};
template <class Kind>
struct ElementOf<Out<Kind>> {
  using Type = Kind;
};

template <class Kind>
std::uint64_t Recorder::encode(const CppOf<Kind>& value) {
  using Cpp = CppOf<Kind>;
  if constexpr (std::is_same_v<Kind, Text>) {
    return keep(value, value ? std::strlen(value) : 0, value ? std::strlen(value) : 0);
  } else if constexpr (std::is_same_v<Kind, In<Text>>) {
    return value.size();
  } else if constexpr (requires { value.data(); }) {
    return keep(value.data(), value.size_bytes(), value.size());
  } else if constexpr (std::is_floating_point_v<Cpp>) {
    const double wide = value;
    std::uint64_t word;
    std::memcpy(&word, &wide, sizeof word);
    return word;
  } else {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(value));
  }
}

}  // namespace shadowlab::gl
