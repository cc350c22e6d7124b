// The kinds of argument that GL's functions take, beside the enumerations of enums.h.
//
// A kind says four things once: the C++ type that our own code passes (Cpp), the type that GL takes
// (Raw), how the first becomes the second (lower), and how a trace prints it. lua/bind.h adds how
// it is read from Lua. GL's integer typedefs do not say which of them a value is, kinds do.
#pragma once

#include <span>
#include <string>
#include <type_traits>

#include "gl/enums.h"

namespace shadowlab::gl {

struct Int {};             ///< GLint
struct Uint {};            ///< GLuint that counts or indexes
struct Mask {};            ///< GLuint of bits, printed in hexadecimal
struct Size {};            ///< GLsizei: not negative
struct Float {};           ///< GLfloat: finite
struct Double {};          ///< GLdouble: finite
struct Bool {};            ///< GLboolean
struct ParameterValue {};  ///< GLint that is an integer or one of TextureParameterValue
struct Text {};            ///< a name: const GLchar*
struct Char {};            ///< a character of a text that GL writes
struct ByteCount {};       ///< GLsizeiptr: not negative
struct Offset {};          ///< const void*: a byte offset into the bound buffer
struct Nothing {};         ///< no result

/// Objects: a name from glGen*. `title` is what a message calls it.
struct ObjectKind {};
struct TextureObject : ObjectKind {
  static constexpr const char* title = "texture";
};
struct SamplerObject : ObjectKind {
  static constexpr const char* title = "sampler";
};
struct FramebufferObject : ObjectKind {
  static constexpr const char* title = "framebuffer";
};
struct RenderbufferObject : ObjectKind {
  static constexpr const char* title = "renderbuffer";
};
struct BufferObject : ObjectKind {
  static constexpr const char* title = "buffer";
};
struct VertexArrayObject : ObjectKind {
  static constexpr const char* title = "vertex_array";
};
struct ShaderObject : ObjectKind {
  static constexpr const char* title = "shader";
};
struct ProgramObject : ObjectKind {
  static constexpr const char* title = "program";
};
struct QueryObject : ObjectKind {
  static constexpr const char* title = "query";
};

/// An array that GL reads; the length comes from a count argument or from the function.
template <class Kind>
struct In {};
/// An array that GL fills.
template <class Kind>
struct Out {};
/// Bytes that GL reads (pixels, vertices); an empty span is a null pointer. `bind` checked the
/// size.
struct Bytes {};
/// Bytes that GL fills; the size was checked.
struct OutBytes {};

// ---- Kind -> C++ type -> GL type
// -----------------------------------------------------------------

template <class Kind>
struct Traits;

template <class T>
struct SameTraits {
  using Cpp = T;
  using Raw = T;
  static Raw lower(Cpp value, GLuint) { return value; }
};
template <>
struct Traits<Int> : SameTraits<GLint> {};
template <>
struct Traits<ParameterValue> : SameTraits<GLint> {};
template <>
struct Traits<Uint> : SameTraits<GLuint> {};
template <>
struct Traits<Mask> : SameTraits<GLuint> {};
template <>
struct Traits<Size> : SameTraits<GLsizei> {};
template <>
struct Traits<Float> : SameTraits<GLfloat> {};
template <>
struct Traits<Double> : SameTraits<GLdouble> {};
template <>
struct Traits<Bool> : SameTraits<GLboolean> {};
template <>
struct Traits<Char> : SameTraits<GLchar> {};
template <>
struct Traits<Text> : SameTraits<const GLchar*> {};
template <>
struct Traits<ByteCount> : SameTraits<GLsizeiptr> {};
template <>
struct Traits<Nothing> {
  using Raw = void;
};
template <>
struct Traits<Offset> {
  using Cpp = GLsizeiptr;
  using Raw = const void*;
  static Raw lower(Cpp value, GLuint) { return reinterpret_cast<const void*>(value); }
};
template <class Kind>
requires std::is_base_of_v<EnumKind, Kind> || std::is_base_of_v<BitsKind, Kind>
struct Traits<Kind> : SameTraits<GLenum> {
};
template <class Kind>
requires std::is_base_of_v<ObjectKind, Kind>
struct Traits<Kind> : SameTraits<GLuint> {
};
/// 0 is the main frame, which is a framebuffer object of ours.
template <>
struct Traits<FramebufferObject> : SameTraits<GLuint> {
  static GLuint lower(GLuint name, GLuint main_frame) { return name == 0 ? main_frame : name; }
};
/// The main frame's colour buffer has the default framebuffer's names; ours is attachment 0.
template <>
struct Traits<ColorBuffer> : SameTraits<GLenum> {
  static GLenum lower(GLenum name, GLuint) {
    switch (name) {
      case GL_FRONT_LEFT:
      case GL_BACK_LEFT:
      case GL_FRONT:
      case GL_BACK:
      case GL_LEFT:
      case GL_FRONT_AND_BACK:
        return GL_COLOR_ATTACHMENT0;
      default:
        return name;
    }
  }
};
/// The accumulation buffer is ours, and cleared by us.
template <>
struct Traits<ClearBits> : SameTraits<GLbitfield> {
  static GLbitfield lower(GLbitfield bits, GLuint) {
    return bits & ~static_cast<GLbitfield>(GL_ACCUM_BUFFER_BIT);
  }
};
template <class Kind>
struct Traits<In<Kind>> {
  using Element = typename Traits<Kind>::Raw;
  using Cpp = std::span<const Element>;
  using Raw = const Element*;
  static Raw lower(Cpp value, GLuint) { return value.data(); }
};
template <>
struct Traits<In<ColorBuffer>> {
  using Element = GLenum;
  using Cpp = std::span<const GLenum>;
  using Raw = const GLenum*;
  struct Lowered {
    std::array<GLenum, 16> names{};
    operator const GLenum*() const { return names.data(); }
  };
  static Lowered lower(Cpp value, GLuint main_frame) {
    Lowered lowered;
    for (std::size_t i = 0; i < value.size() && i < lowered.names.size(); ++i) {
      lowered.names[i] = Traits<ColorBuffer>::lower(value[i], main_frame);
    }
    return lowered;
  }
};
template <class Kind>
struct Traits<Out<Kind>> {
  using Element = typename Traits<Kind>::Raw;
  using Cpp = std::span<Element>;
  using Raw = Element*;
  static Raw lower(Cpp value, GLuint) { return value.data(); }
};
template <>
struct Traits<Bytes> {
  using Cpp = std::span<const std::byte>;
  using Raw = const void*;
  static Raw lower(Cpp value, GLuint) { return value.data(); }
};
template <>
struct Traits<OutBytes> {
  using Cpp = std::span<std::byte>;
  using Raw = void*;
  static Raw lower(Cpp value, GLuint) { return value.data(); }
};

template <class Kind>
using CppOf = typename Traits<Kind>::Cpp;
template <class Kind>
using RawOf = typename Traits<Kind>::Raw;

}  // namespace shadowlab::gl
