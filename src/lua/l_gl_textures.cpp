// Textures and samplers: uploads of checked size, memory counted.
#include <fmt/format.h>

#include <array>

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

// What an image of this size takes, mipmaps included; 16 bytes a texel is the most of
// InternalFormat.
void count_bytes(const Call& call, GLuint texture, GLsizei width, GLsizei height, GLsizei depth,
                 int images) {
  if (width > most_side || height > most_side || depth > most_side) {
    call.refuse(fmt::format("a texture is at most {} texels wide, high and deep", most_side));
  }
  const std::uint64_t texels =
      static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) *
      static_cast<std::uint64_t>(depth) * static_cast<std::uint64_t>(images);
  call.stage.graphics.objects.resize(gl::ObjectType::texture, texture, texels * 16 * 4 / 3);
}

int images_of(GLenum target) { return binding_of(target) == GL_TEXTURE_BINDING_CUBE_MAP ? 6 : 1; }

// OpenGL 4.5, table 8.3.
std::size_t components_of(GLenum format) {
  switch (format) {
    case GL_RG:
    case GL_RG_INTEGER:
      return 2;
    case GL_RGB:
    case GL_BGR:
    case GL_RGB_INTEGER:
      return 3;
    case GL_RGBA:
    case GL_BGRA:
    case GL_RGBA_INTEGER:
      return 4;
    default:
      return 1;  // depth with stencil is packed into one number
  }
}

/// The pixels of `texels` texels as bytes, or none for nil where the image may be empty.
std::vector<std::byte> pixels(const Call& call, int index, std::uint64_t texels, GLenum format,
                              GLenum type) {
  const std::uint64_t needed = texels * components_of(format) * bytes_of_type(type);
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

std::uint64_t area(GLsizei width, GLsizei height, GLsizei depth = 1) {
  return static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) *
         static_cast<std::uint64_t>(depth);
}

int tex_image_2d(lua_State* L) {
  const Call call{L, stage_of_function(L), FunctionId::TexImage2D};
  call.expect(8, 9);
  const GLenum target = call.argument<gl::ImageTarget2D>(1);
  const GLint level = call.argument<gl::Int>(2);
  const GLenum internal = call.argument<gl::InternalFormat>(3);
  const GLsizei width = call.argument<gl::Size>(4), height = call.argument<gl::Size>(5);
  const GLint border = call.argument<gl::Int>(6);
  const GLenum format = call.argument<gl::PixelFormat>(7), type = call.argument<gl::PixelType>(8);
  const GLuint texture = bound_texture(call, target);
  if (level == 0) count_bytes(call, texture, width, height, 1, images_of(target));
  const auto data = pixels(call, 9, area(width, height), format, type);
  const TightRows tight(call);
  call.gl().TexImage2D(target, level, internal, width, height, border, format, type, data);
  call.check_error();
  return 0;
}

int tex_image_3d(lua_State* L) {
  const Call call{L, stage_of_function(L), FunctionId::TexImage3D};
  call.expect(9, 10);
  const GLenum target = call.argument<gl::ImageTarget3D>(1);
  const GLint level = call.argument<gl::Int>(2);
  const GLenum internal = call.argument<gl::InternalFormat>(3);
  const GLsizei width = call.argument<gl::Size>(4), height = call.argument<gl::Size>(5),
                depth = call.argument<gl::Size>(6);
  const GLint border = call.argument<gl::Int>(7);
  const GLenum format = call.argument<gl::PixelFormat>(8), type = call.argument<gl::PixelType>(9);
  const GLuint texture = bound_texture(call, target);
  if (level == 0) count_bytes(call, texture, width, height, depth, 1);
  const auto data = pixels(call, 10, area(width, height, depth), format, type);
  const TightRows tight(call);
  call.gl().TexImage3D(target, level, internal, width, height, depth, border, format, type, data);
  call.check_error();
  return 0;
}

int tex_sub_image_2d(lua_State* L) {
  const Call call{L, stage_of_function(L), FunctionId::TexSubImage2D};
  call.expect(9);
  const GLenum target = call.argument<gl::ImageTarget2D>(1);
  const GLint level = call.argument<gl::Int>(2), x = call.argument<gl::Int>(3),
              y = call.argument<gl::Int>(4);
  const GLsizei width = call.argument<gl::Size>(5), height = call.argument<gl::Size>(6);
  const GLenum format = call.argument<gl::PixelFormat>(7), type = call.argument<gl::PixelType>(8);
  bound_texture(call, target);
  if (lua_isnil(L, 9)) call.wrong_argument(9, "a table of numbers or a string of bytes");
  const auto data = pixels(call, 9, area(width, height), format, type);
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
  const auto first = call.argument<First>(1);
  const GLenum name = call.argument<Parameter>(2);
  (call.gl().*Member)(first, name,
                      read_array_of<GLfloat>(call, 3, name == GL_TEXTURE_BORDER_COLOR ? 4 : 1));
  call.check_error();
  return 0;
}

void stores_2d(const Call& call) {
  const GLenum target = call.argument<gl::StorageTarget2D>(1);
  count_bytes(call, bound_texture(call, target), call.argument<gl::Size>(4),
              call.argument<gl::Size>(5), 1, images_of(target));
}
void stores_3d(const Call& call) {
  const GLenum target = call.argument<gl::ImageTarget3D>(1);
  count_bytes(call, bound_texture(call, target), call.argument<gl::Size>(4),
              call.argument<gl::Size>(5), call.argument<gl::Size>(6), 1);
}
void stores_named(const Call& call) {
  count_bytes(call, call.argument<gl::TextureObject>(1), call.argument<gl::Size>(4),
              call.argument<gl::Size>(5), 1, 6);
}
void aligns(const Call& call) {
  const lua_Integer value = call.integer(2, 1, 8, "1, 2, 4 or 8");
  if ((value & (value - 1)) != 0) call.wrong_argument(2, "1, 2, 4 or 8");
}
// glCopyTexImage2D allocates too.
void copies_image(const Call& call) {
  const GLenum target = call.argument<gl::ImageTarget2D>(1);
  count_bytes(call, bound_texture(call, target), call.argument<gl::Size>(6),
              call.argument<gl::Size>(7), 1, images_of(target));
}

using bind::checked;
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
    {FunctionId::TexParameterfv,
     guarded<parameters<&Functions::TexParameterfv, gl::TextureTarget, gl::TextureParameter>>,
     "gl.TexParameterfv(target, pname, {number, …})"},
    {FunctionId::SamplerParameterfv,
     guarded<parameters<&Functions::SamplerParameterfv, gl::SamplerObject, gl::SamplerParameter>>,
     "gl.SamplerParameterfv(sampler, pname, {number, …})"},
    {FunctionId::TexStorage2D, guarded<checked<&Functions::TexStorage2D, stores_2d>>, nullptr},
    {FunctionId::TexStorage3D, guarded<checked<&Functions::TexStorage3D, stores_3d>>, nullptr},
    {FunctionId::TextureStorage2D, guarded<checked<&Functions::TextureStorage2D, stores_named>>,
     nullptr},
    {FunctionId::CopyTexImage2D, guarded<checked<&Functions::CopyTexImage2D, copies_image>>,
     nullptr},
    {FunctionId::PixelStorei, guarded<checked<&Functions::PixelStorei, aligns>>, nullptr},
};

}  // namespace

std::span<const OwnFunction> gl_texture_functions() { return functions; }

}  // namespace shadowlab::lua
