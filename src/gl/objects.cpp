#include "gl/objects.h"

#include <fmt/format.h>

#include <array>

#include "core/error.h"

namespace shadowlab::gl {

const char* title(ObjectType type) {
  static constexpr std::array titles{"texture",      "sampler", "framebuffer",
                                     "renderbuffer", "buffer",  "vertex array",
                                     "shader",       "program", "query"};
  return titles[static_cast<std::size_t>(type)];
}

ObjectName Objects::add(ObjectType type, GLuint name) {
  if (free_.empty()) {
    if (slots_.size() >= most) {
      throw InputError(fmt::format(
          "more than {} GL objects are alive; delete those that are no longer used, and create "
          "objects in setup rather than in every draw",
          most));
    }
    free_.push_back(static_cast<std::uint32_t>(slots_.size()));
    slots_.emplace_back();
  }
  const std::uint32_t index = free_.back();
  free_.pop_back();
  Slot& slot = slots_[index];
  slot.name = name;
  slot.type = type;
  slot.live = true;
  slot.bytes = 0;
  return {index, slot.generation, type};
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

void Objects::resize(ObjectType type, GLuint name, std::uint64_t bytes) {
  for (Slot& slot : slots_) {
    if (!slot.live || slot.type != type || slot.name != name) continue;
    const std::uint64_t all = bytes_ - slot.bytes + bytes;
    if (all > most_bytes) {
      throw InputError(
          fmt::format("this {} would bring the recipe's GL memory to {} MiB; it may use {}",
                      title(type), all >> 20, most_bytes >> 20));
    }
    bytes_ = all;
    slot.bytes = bytes;
    return;
  }
}

void Objects::clear(const Functions& gl) {
  for (Slot& slot : slots_) {
    if (!slot.live) continue;
    const std::array<GLuint, 1> name{slot.name};
    switch (slot.type) {
      case ObjectType::texture:
        gl.DeleteTextures.unrecorded(1, name);
        break;
      case ObjectType::sampler:
        gl.DeleteSamplers.unrecorded(1, name);
        break;
      case ObjectType::framebuffer:
        gl.DeleteFramebuffers.unrecorded(1, name);
        break;
      case ObjectType::renderbuffer:
        gl.DeleteRenderbuffers.unrecorded(1, name);
        break;
      case ObjectType::buffer:
        gl.DeleteBuffers.unrecorded(1, name);
        break;
      case ObjectType::vertex_array:
        gl.DeleteVertexArrays.unrecorded(1, name);
        break;
      case ObjectType::shader:
        gl.DeleteShader.unrecorded(slot.name);
        break;
      case ObjectType::program:
        gl.DeleteProgram.unrecorded(slot.name);
        break;
      case ObjectType::query:
        gl.DeleteQueries.unrecorded(1, name);
        break;
    }
  }
  slots_.clear();
  free_.clear();
  bytes_ = 0;
}

}  // namespace shadowlab::gl
