// fbo: short forms for the common targets, and the accumulation buffer's storage.
#include <fmt/format.h>

#include <array>

#include "gl/sizes.h"
#include "lua/boxes.h"
#include "lua/object.h"

namespace shadowlab::lua {
namespace {

int size_argument(lua_State* L, int index, const char* function) {
  const double value =
      read<double>(L, index, fmt::format("argument {} of fbo.{}", index, function).c_str());
  if (value != std::floor(value) || value < 1 || value > 16384) {
    throw InputError(fmt::format("argument {} of fbo.{} must be a size, 1 to 16384; it is {}",
                                 index, function, value));
  }
  return static_cast<int>(value);
}

// A texture attached to a new framebuffer, both given to Lua: framebuffer, texture.
int give(lua_State* L, GLenum target, GLenum internal, int width, int height,
         const char* function) {
  Stage& stage = Stage::of(L);
  const gl::Functions& gl = stage.graphics.gl;
  const gl::Untraced untraced(stage.graphics.calls());
  std::array<GLint, 4> before{};
  const bool cube = target == GL_TEXTURE_CUBE_MAP;
  gl.GetIntegerv(cube ? GL_TEXTURE_BINDING_CUBE_MAP : GL_TEXTURE_BINDING_2D, before);
  const auto texture_before = static_cast<GLuint>(before[0]);
  gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, before);
  const auto frame_before = static_cast<GLuint>(before[0]);

  std::array<GLuint, 1> texture{}, frame{};
  gl.GenFramebuffers(1, frame);
  push_objects(stage, L, gl::ObjectType::framebuffer, frame);
  gl.GenTextures(1, texture);
  push_objects(stage, L, gl::ObjectType::texture, texture);
  stage.objects.resize(gl::ObjectType::texture, texture[0],
                       gl::texel_bytes(internal) * static_cast<std::uint64_t>(width) *
                           static_cast<std::uint64_t>(height) * (cube ? 6 : 1));
  gl.BindTexture(target, texture[0]);
  const bool depth = internal == GL_DEPTH_COMPONENT24 || internal == GL_DEPTH_COMPONENT16 ||
                     internal == GL_DEPTH_COMPONENT32F;
  for (GLenum face = 0; face < (cube ? 6u : 1u); ++face) {
    gl.TexImage2D(cube ? GL_TEXTURE_CUBE_MAP_POSITIVE_X + face : target, 0, internal, width, height,
                  0, depth ? GL_DEPTH_COMPONENT : GL_RGBA, GL_FLOAT, {});
  }
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TexParameteri(target, filter, GL_NEAREST);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    gl.TexParameteri(target, wrap, GL_CLAMP_TO_EDGE);
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, frame[0]);
  gl.FramebufferTexture2D(GL_DRAW_FRAMEBUFFER, depth ? GL_DEPTH_ATTACHMENT : GL_COLOR_ATTACHMENT0,
                          cube ? GL_TEXTURE_CUBE_MAP_POSITIVE_X : target, texture[0], 0);
  if (depth) {
    gl.DrawBuffers(1, std::array<GLenum, 1>{GL_NONE});
    gl.NamedFramebufferReadBuffer ? gl.NamedFramebufferReadBuffer(frame[0], GL_NONE) : void();
  }
  const GLenum status = gl.CheckFramebufferStatus(GL_DRAW_FRAMEBUFFER);
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, frame_before);
  gl.BindTexture(target, texture_before);
  const GLenum error = gl.GetError.pointer();  // asked for in any case: it is not another call's
  if (status != GL_FRAMEBUFFER_COMPLETE || error != GL_NO_ERROR) {
    throw InputError(fmt::format("fbo.{}: this context cannot draw to that format", function));
  }
  return 2;
}

int depth(lua_State* L) {
  const int width = size_argument(L, 1, "depth"), height = size_argument(L, 2, "depth");
  return give(L, GL_TEXTURE_2D, GL_DEPTH_COMPONENT24, width, height, "depth");
}

int color(lua_State* L) {
  const int width = size_argument(L, 1, "color"), height = size_argument(L, 2, "color");
  GLenum format = GL_RGBA8;
  if (!lua_isnoneornil(L, 3)) {
    format = static_cast<GLenum>(lua_tointeger(L, 3));
    if (!gl::is_one_of<gl::InternalFormat>(format))
      throw InputError("argument 3 of fbo.color must be a format, as gl.RGBA32F; it is " +
                       describe(L, 3));
  }
  return give(L, GL_TEXTURE_2D, format, width, height, "color");
}

int cube_depth(lua_State* L) {
  const int size = size_argument(L, 1, "cube_depth");
  return give(L, GL_TEXTURE_CUBE_MAP, GL_DEPTH_COMPONENT24, size, size, "cube_depth");
}

int accumulation(lua_State* L) {
  if (lua_type(L, 1) != LUA_TSTRING)
    throw InputError("fbo.accumulation takes snorm8, snorm16, float16 or float32; it is " +
                     describe(L, 1));
  Stage::of(L).graphics.accumulation.choose(gl::accum_storage_named(lua_tostring(L, 1)));
  return 0;
}

constexpr Entry functions[] = {
    {"depth", "fbo.depth(width, height) -> framebuffer, texture",
     "A framebuffer with a 24-bit depth texture alone: a shadow map.", guarded<depth>},
    {"color", "fbo.color(width, height, format) -> framebuffer, texture",
     "A framebuffer with a colour texture, gl.RGBA8 unless given.", guarded<color>},
    {"cube_depth", "fbo.cube_depth(size) -> framebuffer, texture",
     "A framebuffer with the first face of a cube map of depths attached; attach the others by "
     "gl.FramebufferTexture2D.",
     guarded<cube_depth>},
    {"accumulation", "fbo.accumulation(storage)",
     "How the accumulation buffer stores: \"snorm8\", \"snorm16\" (each frame's default), "
     "\"float16\" or \"float32\". What was accumulated is gone.",
     guarded<accumulation>},
};

}  // namespace

std::span<const Entry> fbo_functions() { return functions; }

void open_fbo(Stage& stage) {
  lua_State* L = stage.state.raw();
  lua_newtable(L);
  set_functions(L, functions);
  refuse_unknown_names(L, -1, "fbo");
  lua_setglobal(L, "fbo");
}

}  // namespace shadowlab::lua
