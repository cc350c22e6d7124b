// glGen*, glCreate*, glDelete*: names of objects.
#include <fmt/format.h>

#include <utility>
#include <vector>

#include "lua/bind.h"
#include "lua/l_gl.h"

namespace shadowlab::lua {
namespace {

constexpr int most_at_once = 1024;

int read_count(const Call& call, int index) {
  return static_cast<int>(call.integer(index, 0, most_at_once, "a number of objects, 0 to 1024"));
}

int give(const Call& call, gl::ObjectType type, std::span<const GLuint> names) {
  call.check_error();
  push_objects(call.stage, call.L, type, names);
  return static_cast<int>(names.size());
}

// GL binds its own framebuffer 0 in place of a deleted one; here 0 is the main frame.
void bind_main_frame_for_none(const gl::Functions& gl) {
  for (const auto& [target, binding] :
       {std::pair(GL_DRAW_FRAMEBUFFER, GL_DRAW_FRAMEBUFFER_BINDING),
        std::pair(GL_READ_FRAMEBUFFER, GL_READ_FRAMEBUFFER_BINDING)}) {
    GLint bound = 0;
    gl.GetIntegerv.unrecorded(binding, {&bound, 1});
    if (bound == 0) gl.BindFramebuffer.unrecorded(target, 0);
  }
}

/// gl.GenTextures(n): n objects, as n results.
template <auto Member, class Kind>
int generate(lua_State* L) {
  using Function = std::remove_cvref_t<decltype(std::declval<gl::Functions>().*Member)>;
  const Call call{L, stage_of_function(L), Function::id};
  const auto& function = call.gl().*Member;
  if (!function) not_in_this_context(call);
  call.expect(1);
  std::vector<GLuint> names(static_cast<std::size_t>(read_count(call, 1)));
  function(static_cast<GLsizei>(names.size()), names);
  return give(call, gl::object_type<Kind>, names);
}

int create_textures(lua_State* L) {
  const Call call{L, stage_of_function(L), gl::FunctionId::CreateTextures};
  if (!call.gl().CreateTextures) not_in_this_context(call);
  call.expect(2);
  const GLenum target = call.argument<gl::TextureTarget>(1);
  std::vector<GLuint> names(static_cast<std::size_t>(read_count(call, 2)));
  call.gl().CreateTextures(target, static_cast<GLsizei>(names.size()), names);
  return give(call, gl::ObjectType::texture, names);
}

/// gl.DeleteTextures(n, {…}), gl.DeleteTextures(1, texture) or gl.DeleteTextures(2, a, b).
template <auto Member, class Kind>
int remove(lua_State* L) {
  using Function = std::remove_cvref_t<decltype(std::declval<gl::Functions>().*Member)>;
  const Call call{L, stage_of_function(L), Function::id};
  if (lua_gettop(L) < 2) call.wrong_count(2);
  const int count = read_count(call, 1);
  if (lua_type(L, 2) == LUA_TTABLE) {
    call.expect(2);
    luaL_checkstack(L, count + 4, "too many objects at once");
    for (int i = 1; i <= count; ++i) lua_rawgeti(L, 2, i);
    lua_remove(L, 2);
  }
  if (lua_gettop(L) - 1 != count) {
    call.refuse(fmt::format("n is {}, but {} object{} given", count, lua_gettop(L) - 1,
                            lua_gettop(L) == 2 ? " is" : "s are"));
  }
  std::vector<GLuint> names;
  std::vector<gl::ObjectName> objects;
  for (int i = 2; i <= count + 1; ++i) {
    const auto object = object_at(call, i, gl::object_type<Kind>);
    const auto name = object ? call.stage.objects.find(*object) : std::nullopt;
    if (!name) continue;  // GL ignores 0 and what is gone already
    names.push_back(*name);
    objects.push_back(*object);
  }
  (call.gl().*Member)(static_cast<GLsizei>(names.size()), names);
  for (std::size_t i = 0; i < names.size(); ++i) {
    call.stage.objects.remove(objects[i]);
    if constexpr (std::is_same_v<Kind, gl::BufferObject>)
      call.stage.graphics.vertices.remove_buffer(names[i]);
    if constexpr (std::is_same_v<Kind, gl::VertexArrayObject>)
      call.stage.graphics.vertices.remove_array(names[i]);
  }
  if constexpr (std::is_same_v<Kind, gl::FramebufferObject>) bind_main_frame_for_none(call.gl());
  call.check_error();
  return 0;
}

using gl::FunctionId;
using gl::Functions;
constexpr OwnFunction functions[] = {
    {FunctionId::GenTextures, guarded<generate<&Functions::GenTextures, gl::TextureObject>>,
     "gl.GenTextures(n) -> n textures"},
    {FunctionId::GenSamplers, guarded<generate<&Functions::GenSamplers, gl::SamplerObject>>,
     "gl.GenSamplers(n) -> n samplers"},
    {FunctionId::GenFramebuffers,
     guarded<generate<&Functions::GenFramebuffers, gl::FramebufferObject>>,
     "gl.GenFramebuffers(n) -> n framebuffers"},
    {FunctionId::CreateFramebuffers,
     guarded<generate<&Functions::CreateFramebuffers, gl::FramebufferObject>>,
     "gl.CreateFramebuffers(n) -> n framebuffers"},
    {FunctionId::GenRenderbuffers,
     guarded<generate<&Functions::GenRenderbuffers, gl::RenderbufferObject>>,
     "gl.GenRenderbuffers(n) -> n renderbuffers"},
    {FunctionId::CreateRenderbuffers,
     guarded<generate<&Functions::CreateRenderbuffers, gl::RenderbufferObject>>,
     "gl.CreateRenderbuffers(n) -> n renderbuffers"},
    {FunctionId::GenBuffers, guarded<generate<&Functions::GenBuffers, gl::BufferObject>>,
     "gl.GenBuffers(n) -> n buffers"},
    {FunctionId::GenVertexArrays,
     guarded<generate<&Functions::GenVertexArrays, gl::VertexArrayObject>>,
     "gl.GenVertexArrays(n) -> n vertex arrays"},
    {FunctionId::GenQueries, guarded<generate<&Functions::GenQueries, gl::QueryObject>>,
     "gl.GenQueries(n) -> n queries"},
    {FunctionId::CreateTextures, guarded<create_textures>,
     "gl.CreateTextures(target, n) -> n textures"},
    {FunctionId::DeleteTextures, guarded<remove<&Functions::DeleteTextures, gl::TextureObject>>,
     "gl.DeleteTextures(n, textures…)"},
    {FunctionId::DeleteSamplers, guarded<remove<&Functions::DeleteSamplers, gl::SamplerObject>>,
     "gl.DeleteSamplers(n, samplers…)"},
    {FunctionId::DeleteFramebuffers,
     guarded<remove<&Functions::DeleteFramebuffers, gl::FramebufferObject>>,
     "gl.DeleteFramebuffers(n, framebuffers…)"},
    {FunctionId::DeleteRenderbuffers,
     guarded<remove<&Functions::DeleteRenderbuffers, gl::RenderbufferObject>>,
     "gl.DeleteRenderbuffers(n, renderbuffers…)"},
    {FunctionId::DeleteBuffers, guarded<remove<&Functions::DeleteBuffers, gl::BufferObject>>,
     "gl.DeleteBuffers(n, buffers…)"},
    {FunctionId::DeleteVertexArrays,
     guarded<remove<&Functions::DeleteVertexArrays, gl::VertexArrayObject>>,
     "gl.DeleteVertexArrays(n, arrays…)"},
    {FunctionId::DeleteQueries, guarded<remove<&Functions::DeleteQueries, gl::QueryObject>>,
     "gl.DeleteQueries(n, ids…)"},
};

}  // namespace

std::span<const OwnFunction> gl_object_functions() { return functions; }

}  // namespace shadowlab::lua
