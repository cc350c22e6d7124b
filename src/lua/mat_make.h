// The functions of mat3 and mat4 that make a matrix from something other than its elements.
#pragma once

#include <lua.hpp>

namespace shadowlab::lua {

int mat3_rotate(lua_State* L);
int mat3_scale(lua_State* L);

int mat4_look_at(lua_State* L);
int mat4_perspective(lua_State* L);
int mat4_ortho(lua_State* L);
int mat4_frustum(lua_State* L);
int mat4_translate(lua_State* L);
int mat4_rotate(lua_State* L);
int mat4_scale(lua_State* L);

}  // namespace shadowlab::lua
