#include "gl/objects.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "core/error.h"
#include "gl/vertex_input.h"

namespace shadowlab::gl {

namespace {

void delete_object(const Functions& gl, ObjectType type, GLuint object) {
  const std::array<GLuint, 1> name{object};
  switch (type) {
    case ObjectType::texture:
      return gl.DeleteTextures.unrecorded(1, name);
    case ObjectType::sampler:
      return gl.DeleteSamplers.unrecorded(1, name);
    case ObjectType::framebuffer:
      return gl.DeleteFramebuffers.unrecorded(1, name);
    case ObjectType::renderbuffer:
      return gl.DeleteRenderbuffers.unrecorded(1, name);
    case ObjectType::buffer:
      return gl.DeleteBuffers.unrecorded(1, name);
    case ObjectType::vertex_array:
      return gl.DeleteVertexArrays.unrecorded(1, name);
    case ObjectType::shader:
      return gl.DeleteShader.unrecorded(object);
    case ObjectType::program:
      return gl.DeleteProgram.unrecorded(object);
    case ObjectType::query:
      return gl.DeleteQueries.unrecorded(1, name);
  }
}

}  // namespace

const char* title(ObjectType type) {
  static constexpr std::array titles{"texture",      "sampler", "framebuffer",
                                     "renderbuffer", "buffer",  "vertex array",
                                     "shader",       "program", "query"};
  return titles[static_cast<std::size_t>(type)];
}

std::vector<ObjectName> Objects::add(const Functions& gl, ObjectType type,
                                     std::span<const GLuint> names) {
  std::vector<ObjectName> added;
  added.reserve(names.size());
  if (slots_.size() - free_.size() + names.size() > most) {
    for (const GLuint name : names) delete_object(gl, type, name);
    throw InputError(fmt::format(
        "more than {} GL objects are alive; delete those that are no longer used, and create "
        "objects in setup rather than in every draw",
        most));
  }
  for (const GLuint name : names) {
    if (free_.empty()) {
      free_.push_back(static_cast<std::uint32_t>(slots_.size()));
      slots_.emplace_back();
    }
    const std::uint32_t index = free_.back();
    free_.pop_back();
    Slot& slot = slots_[index];
    slot = {name, slot.generation, type, true, 0};
    added.push_back({index, slot.generation, type});
  }
  return added;
}

std::optional<GLuint> Objects::find(ObjectName name) const {
  if (name.slot >= slots_.size()) return {};
  const Slot& slot = slots_[name.slot];
  if (!slot.live || slot.generation != name.generation) return {};
  return slot.name;
}

void Objects::remove(ObjectName name) {
  if (!find(name)) return;
  Slot& slot = slots_[name.slot];
  bytes_ -= slot.bytes;
  slot.live = false;
  ++slot.generation;
  free_.push_back(name.slot);
}

Objects::Slot* Objects::find_slot(ObjectType type, GLuint name) {
  for (Slot& slot : slots_) {
    if (slot.live && slot.type == type && slot.name == name) return &slot;
  }
  return nullptr;
}

void Objects::set_bytes(Slot& slot, std::uint64_t bytes) {
  const std::uint64_t all = bytes_ - slot.bytes + bytes;
  if (all > most_bytes) {
    throw InputError(
        fmt::format("this {} would bring the recipe's GL memory to {} MiB; it may use {}",
                    title(slot.type), all >> 20, most_bytes >> 20));
  }
  bytes_ = all;
  slot.bytes = bytes;
}

void Objects::resize(ObjectType type, GLuint name, std::uint64_t bytes) {
  if (Slot* slot = find_slot(type, name)) set_bytes(*slot, bytes);
}

void Objects::grow(ObjectType type, GLuint name, std::uint64_t bytes) {
  if (Slot* slot = find_slot(type, name)) set_bytes(*slot, std::max(slot->bytes, bytes));
}

void Objects::clear(const Functions& gl, VertexInput& vertices) {
  for (Slot& slot : slots_) {
    if (!slot.live) continue;
    delete_object(gl, slot.type, slot.name);
    if (slot.type == ObjectType::buffer) vertices.remove_buffer(slot.name);
    if (slot.type == ObjectType::vertex_array) vertices.remove_array(slot.name);
    slot.live = false;
    ++slot.generation;
  }
  free_.resize(slots_.size());
  std::iota(free_.begin(), free_.end(), 0u);
  bytes_ = 0;
}

}  // namespace shadowlab::gl
