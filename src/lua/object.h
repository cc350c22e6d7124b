// GL objects as Lua values: userdata with a slot and a generation, never an integer.
#pragma once

#include "gl/objects.h"
#include "lua/stage.h"

namespace shadowlab::lua {

struct Call;

/// Makes the metatables; once for a state.
void open_objects(lua_State* L);

/// Gives the new GL objects to Lua, and pushes them. What fails on the way leaks nothing: the stage
/// has taken all of them before.
void push_objects(Stage& stage, lua_State* L, gl::ObjectType type, std::span<const GLuint> names);
inline void push_object(Stage& stage, lua_State* L, gl::ObjectType type, GLuint name) {
  push_objects(stage, L, type, {&name, 1});
}

/// The object at `index`, which may be 0 (none; of framebuffers, the main frame). Throws InputError
/// for anything else: another type, a deleted object.
GLuint read_object(const Call& call, int index, gl::ObjectType type);

/// The object's name and slot, for deletion; nothing for 0 and for what was deleted already, which
/// GL ignores too.
std::optional<gl::ObjectName> object_at(const Call& call, int index, gl::ObjectType type);

}  // namespace shadowlab::lua
