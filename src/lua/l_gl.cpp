// gl.*: every function of functions.def, every constant of enums.h.
#include <array>
#include <map>

#include "lua/bind.h"
#include "lua/l_gl.h"

namespace shadowlab::lua {
namespace {

// nullptr for the functions that are bound by hand or not at all.
constexpr std::array<lua_CFunction, static_cast<std::size_t>(gl::FunctionId::count)>
    plain_functions{
#define SHADOWLAB_GL(result, name, ...) &guarded<&bind::plain<&gl::Functions::name>>,
#define SHADOWLAB_GL_OWN(...) nullptr,
#define SHADOWLAB_GL_CORE(...) nullptr,
#include "gl/functions.def"
#undef SHADOWLAB_GL
#undef SHADOWLAB_GL_OWN
#undef SHADOWLAB_GL_CORE
    };

void set_function(Stage& stage, gl::FunctionId id, lua_CFunction function) {
  lua_State* L = stage.state.raw();
  lua_pushlightuserdata(L, &stage);
  lua_pushcclosure(L, function, 1);
  lua_setfield(L, -2, std::string(gl::describe(id).name).c_str());
}

}  // namespace

std::vector<OwnFunction> own_functions() {
  std::vector<OwnFunction> all;
  for (const auto part : {gl_frame_functions(), gl_object_functions(), gl_texture_functions(),
                          gl_vertex_functions(), gl_program_functions(), gl_query_functions()}) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

void open_gl(Stage& stage) {
  lua_State* L = stage.state.raw();
  open_objects(L);
  const auto constants = gl::all_constants();
  lua_createtable(L, 0, static_cast<int>(constants.size() + plain_functions.size()));
  for (const gl::Constant& constant : constants) {
    lua_pushinteger(L, constant.value);
    lua_setfield(L, -2, std::string(constant.name).c_str());
  }
  for (std::size_t i = 0; i < plain_functions.size(); ++i) {
    if (plain_functions[i]) set_function(stage, static_cast<gl::FunctionId>(i), plain_functions[i]);
  }
  for (const OwnFunction& own : own_functions()) set_function(stage, own.function, own.call);
  refuse_unknown_names(L, -1, "gl");
  lua_setglobal(L, "gl");
}

}  // namespace shadowlab::lua
