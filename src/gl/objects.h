// The names of GL objects that a recipe holds.
//
// A recipe never sees GL's integers: it holds a slot and a generation, so that a name used after
// its deletion, or in another context, is an error with a sentence instead of somebody else's
// object.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "gl/functions.h"

namespace shadowlab::gl {

enum class ObjectType : std::uint8_t {
  texture,
  sampler,
  framebuffer,
  renderbuffer,
  buffer,
  vertex_array,
  shader,
  program,
  query
};

template <class Kind>
constexpr ObjectType object_type = ObjectType::texture;
template <>
inline constexpr ObjectType object_type<SamplerObject> = ObjectType::sampler;
template <>
inline constexpr ObjectType object_type<FramebufferObject> = ObjectType::framebuffer;
template <>
inline constexpr ObjectType object_type<RenderbufferObject> = ObjectType::renderbuffer;
template <>
inline constexpr ObjectType object_type<BufferObject> = ObjectType::buffer;
template <>
inline constexpr ObjectType object_type<VertexArrayObject> = ObjectType::vertex_array;
template <>
inline constexpr ObjectType object_type<ShaderObject> = ObjectType::shader;
template <>
inline constexpr ObjectType object_type<ProgramObject> = ObjectType::program;
template <>
inline constexpr ObjectType object_type<QueryObject> = ObjectType::query;

/// "texture", "vertex array": for messages.
const char* title(ObjectType type);

class VertexInput;

struct ObjectName {
  std::uint32_t slot = 0;
  std::uint32_t generation = 0;
  ObjectType type = ObjectType::texture;
  bool operator==(const ObjectName&) const = default;
};

class Objects {
 public:
  /// How many objects may live at once; a recipe that wants more is in error.
  static constexpr std::size_t most = 65536;
  /// How many bytes textures, renderbuffers and buffers may take together.
  static constexpr std::uint64_t most_bytes = std::uint64_t{1} << 30;

  /// Takes the new objects. Throws InputError past `most`, having deleted them.
  std::vector<ObjectName> add(const Functions& gl, ObjectType type, std::span<const GLuint> names);
  /// GL's name; nothing once the object was removed.
  std::optional<GLuint> find(ObjectName name) const;
  void remove(ObjectName name);
  /// States that the live object `name` of `type` now takes `bytes`, or at least so many; throws
  /// InputError past `most_bytes`, before GL is asked for them.
  void resize(ObjectType type, GLuint name, std::uint64_t bytes);
  void grow(ObjectType type, GLuint name, std::uint64_t bytes);
  std::uint64_t bytes() const { return bytes_; }

  /// Deletes what is left, in GL and of what `vertices` knows.
  void clear(const Functions& gl, VertexInput& vertices);

 private:
  struct Slot {
    GLuint name = 0;
    std::uint32_t generation = 1;
    ObjectType type = ObjectType::texture;
    bool live = false;
    std::uint64_t bytes = 0;
  };
  Slot* find_slot(ObjectType type, GLuint name);
  void set_bytes(Slot& slot, std::uint64_t bytes);

  std::vector<Slot> slots_;
  std::vector<std::uint32_t> free_;
  std::uint64_t bytes_ = 0;
};

}  // namespace shadowlab::gl
