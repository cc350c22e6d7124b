// The parts of gl.*: each l_gl_*.cpp gives the functions that it binds by hand.
#pragma once

#include <span>

#include "gl/functions.h"
#include "lua/stage.h"

namespace shadowlab::lua {

struct OwnFunction {
  gl::FunctionId function;
  lua_CFunction call;  ///< with the stage as its first upvalue
  const char*
      signature;  ///< as Lua writes it, where it differs from C: "gl.GenTextures(n) -> texture…"
};

std::span<const OwnFunction> gl_frame_functions();
std::span<const OwnFunction> gl_object_functions();
std::span<const OwnFunction> gl_texture_functions();
std::span<const OwnFunction> gl_vertex_functions();
std::span<const OwnFunction> gl_program_functions();
std::span<const OwnFunction> gl_query_functions();

/// All of the above.
std::vector<OwnFunction> own_functions();

}  // namespace shadowlab::lua
