// Textures and samplers: uploads of checked size, memory counted.
#include <fmt/format.h>

#include <array>

#include "gl/sizes.h"
#include "lua/array.h"
#include "lua/bind.h"
#include "lua/l_gl.h"

namespace shadowlab::lua {
namespace {

using gl::FunctionId;

constexpr GLsizei most_side = 16384;

GLenum binding_of(GLenum target) {
  switch (target) {
    case GL_TEXTURE_2D:
      return GL_TEXTURE_BINDING_2D;
    case GL_TEXTURE_2D_ARRAY:
      return GL_TEXTURE_BINDING_2D_ARRAY;
    case GL_TEXTURE_3D:
      return GL_TEXTURE_BINDING_3D;
    case GL_TEXTURE_1D:
      return GL_TEXTURE_BINDING_1D;
    case GL_TEXTURE_RECTANGLE:
      return GL_TEXTURE_BINDING_RECTANGLE;
    default:
      return GL_TEXTURE_BINDING_CUBE_MAP;  // and its faces
  }
}

GLuint bound_texture(const Call& call, GLenum target) {
  GLint name = 0;
  call.gl().GetIntegerv.unrecorded(binding_of(target), {&name, 1});
  if (name == 0) call.refuse("no texture is bound to this target; call gl.BindTexture first");
  return static_cast<GLuint>(name);
}

struct Extent {
  GLsizei width, height, depth = 1;
  std::uint64_t texels() const {
    return static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) *
           static_cast<std::uint64_t>(depth);
  }
};

void check_sides(const Call& call, const Extent& extent) {
  if (extent.width > most_side || extent.height > most_side || extent.depth > most_side) {
    call.refuse(fmt::format("a texture is at most {} texels wide, high and deep", most_side));
  }
}

// What an image takes, with all the levels of which it is one.
void count_bytes(const Call& call, GLuint texture, GLint level, GLenum internal,
                 const Extent& extent, int images) {
  check_sides(call, extent);
  if (level < 0 || level > 14) call.refuse("a level is 0 to 14");
  const std::uint64_t texels =
      (extent.texels() << (2 * level)) * static_cast<std::uint64_t>(images);
  call.stage.objects.grow(gl::ObjectType::texture, texture,
                          texels * gl::texel_bytes(internal) * 4 / 3);
}

int images_of(GLenum target) { return binding_of(target) == GL_TEXTURE_BINDING_CUBE_MAP ? 6 : 1; }

/// The pixels of an image as bytes, or none for nil where it may be empty.
std::vector<std::byte> pixels(const Call& call, int index, const Extent& extent, GLenum format,
                              GLenum type) {
  const std::uint64_t needed =
      extent.texels() * gl::components_of(format) * gl::bytes_of_type(type);
  if (needed > gl::Objects::most_bytes) call.refuse("the image is too large");
  auto bytes = read_bytes(call, index, type, needed);
  const bool none = lua_isnoneornil(call.L, index);
  if (!none && bytes.size() != needed) {
    call.refuse(fmt::format("pixels has {} bytes; this size, format and type take {}", bytes.size(),
                            needed));
  }
  return bytes;
}

/// Rows of any width without padding, whatever gl.PixelStorei says: Lua's tables have none.
class TightRows {
 public:
  explicit TightRows(const Call& call) : gl_(call.gl()) {
    gl_.GetIntegerv.unrecorded(GL_UNPACK_ALIGNMENT, {&before_, 1});
    gl_.PixelStorei.unrecorded(GL_UNPACK_ALIGNMENT, 1);
  }
  ~TightRows() { gl_.PixelStorei.unrecorded(GL_UNPACK_ALIGNMENT, before_); }
  TightRows(const TightRows&) = delete;
  TightRows& operator=(const TightRows&) = delete;

 private:
  const gl::Functions& gl_;
  GLint before_ = 4;
};

int tex_image_2d(lua_State* L) {
  const Call call{L, stage_of_function(L), FunctionId::TexImage2D};
  call.expect(8, 9);
  const auto [target, level, internal, width, height, border, format, type] =
      call.arguments<gl::ImageTarget2D, gl::Int, gl::InternalFormat, gl::Size, gl::Size, gl::Int,
                     gl::PixelFormat, gl::PixelType>();
  const GLuint texture = bound_texture(call, target);
  count_bytes(call, texture, level, internal, {width, height}, images_of(target));
  const auto data = pixels(call, 9, {width, height}, format, type);
  const TightRows tight(call);
  call.gl().TexImage2D(target, level, internal, width, height, border, format, type, data);
  call.check_error();
  return 0;
}

int tex_image_3d(lua_State* L) {
  const Call call{L, stage_of_function(L), FunctionId::TexImage3D};
  call.expect(9, 10);
  const auto [target, level, internal, width, height, depth, border, format, type] =
      call.arguments<gl::ImageTarget3D, gl::Int, gl::InternalFormat, gl::Size, gl::Size, gl::Size,
                     gl::Int, gl::PixelFormat, gl::PixelType>();
  const GLuint texture = bound_texture(call, target);
  count_bytes(call, texture, level, internal, {width, height, depth}, 1);
  const auto data = pixels(call, 10, {width, height, depth}, format, type);
  const TightRows tight(call);
  call.gl().TexImage3D(target, level, internal, width, height, depth, border, format, type, data);
  call.check_error();
  return 0;
}

int tex_sub_image_2d(lua_State* L) {
  const Call call{L, stage_of_function(L), FunctionId::TexSubImage2D};
  call.expect(9);
  const auto [target, level, x, y, width, height, format, type] =
      call.arguments<gl::ImageTarget2D, gl::Int, gl::Int, gl::Int, gl::Size, gl::Size,
                     gl::PixelFormat, gl::PixelType>();
  bound_texture(call, target);
  check_sides(call, {width, height});
  if (lua_isnil(L, 9)) call.wrong_argument(9, "a table of numbers or a string of bytes");
  const auto data = pixels(call, 9, {width, height}, format, type);
  const TightRows tight(call);
  call.gl().TexSubImage2D(target, level, x, y, width, height, format, type, data);
  call.check_error();
  return 0;
}

// The border colour is four numbers, every other parameter one.
template <auto Member, class First, class Parameter>
int parameters(lua_State* L) {
  using Function = std::remove_cvref_t<decltype(std::declval<gl::Functions>().*Member)>;
  const Call call{L, stage_of_function(L), Function::id};
  call.expect(3);
  const auto [first, name] = call.arguments<First, Parameter>();
  const auto values = read_array_of<GLfloat>(call, 3, name == GL_TEXTURE_BORDER_COLOR ? 4 : 1);
  if constexpr (std::is_same_v<First, gl::TextureTarget>) bound_texture(call, first);
  (call.gl().*Member)(first, name, values);
  call.check_error();
  return 0;
}

// ---- what is checked before the functions that take their arguments as they are

constexpr auto needs_texture = [](const Call& call, GLenum target, auto...) {
  bound_texture(call, target);
};

// As many units as gl.TEXTUREi has names.
void counts_units(const Call& call, GLuint unit, GLuint) {
  constexpr GLuint units = gl::TextureUnit::values.size();
  if (unit >= units)
    call.wrong_argument(1, fmt::format("the number of a texture unit, 0 to {}", units - 1));
}
void stores_2d(const Call& call, GLenum target, GLsizei, GLenum internal, GLsizei width,
               GLsizei height) {
  count_bytes(call, bound_texture(call, target), 0, internal, {width, height}, images_of(target));
}
void stores_3d(const Call& call, GLenum target, GLsizei, GLenum internal, GLsizei width,
               GLsizei height, GLsizei depth) {
  count_bytes(call, bound_texture(call, target), 0, internal, {width, height, depth}, 1);
}
void stores_named(const Call& call, GLuint texture, GLsizei, GLenum internal, GLsizei width,
                  GLsizei height) {
  count_bytes(call, texture, 0, internal, {width, height}, 6);
}
void aligns(const Call& call, GLenum, GLint value) {
  if (value != 1 && value != 2 && value != 4 && value != 8) call.wrong_argument(2, "1, 2, 4 or 8");
}
// glCopyTexImage2D allocates too.
void copies_image(const Call& call, GLenum target, GLint level, GLenum internal, GLint, GLint,
                  GLsizei width, GLsizei height, GLint) {
  count_bytes(call, bound_texture(call, target), level, internal, {width, height},
              images_of(target));
}

using bind::plain;
using gl::Functions;
constexpr OwnFunction functions[] = {
    {FunctionId::TexImage2D, guarded<tex_image_2d>,
     "gl.TexImage2D(target, level, internalformat, width, height, border, format, type, pixels: "
     "nil | {number, …} | bytes)"},
    {FunctionId::TexImage3D, guarded<tex_image_3d>,
     "gl.TexImage3D(target, level, internalformat, width, height, depth, border, format, type, "
     "pixels: nil | {number, …} | bytes)"},
    {FunctionId::TexSubImage2D, guarded<tex_sub_image_2d>,
     "gl.TexSubImage2D(target, level, xoffset, yoffset, width, height, format, type, pixels: "
     "{number, …} | bytes)"},
    {FunctionId::BindTextureUnit, guarded<plain<&Functions::BindTextureUnit, counts_units>>,
     nullptr},
    {FunctionId::BindSampler, guarded<plain<&Functions::BindSampler, counts_units>>, nullptr},
    {FunctionId::TexParameteri, guarded<plain<&Functions::TexParameteri, needs_texture>>, nullptr},
    {FunctionId::TexParameterf, guarded<plain<&Functions::TexParameterf, needs_texture>>, nullptr},
    {FunctionId::TexParameterfv,
     guarded<parameters<&Functions::TexParameterfv, gl::TextureTarget, gl::TextureParameter>>,
     "gl.TexParameterfv(target, pname, {number, …})"},
    {FunctionId::SamplerParameterfv,
     guarded<parameters<&Functions::SamplerParameterfv, gl::SamplerObject, gl::SamplerParameter>>,
     "gl.SamplerParameterfv(sampler, pname, {number, …})"},
    {FunctionId::TexStorage2D, guarded<plain<&Functions::TexStorage2D, stores_2d>>, nullptr},
    {FunctionId::TexStorage3D, guarded<plain<&Functions::TexStorage3D, stores_3d>>, nullptr},
    {FunctionId::TextureStorage2D, guarded<plain<&Functions::TextureStorage2D, stores_named>>,
     nullptr},
    {FunctionId::CopyTexImage2D, guarded<plain<&Functions::CopyTexImage2D, copies_image>>, nullptr},
    {FunctionId::PixelStorei, guarded<plain<&Functions::PixelStorei, aligns>>, nullptr},
};

}  // namespace

std::span<const OwnFunction> gl_texture_functions() { return functions; }

}  // namespace shadowlab::lua
