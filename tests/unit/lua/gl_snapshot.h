// All state of a context that functions of gl.* can change, as text: for telling what changed.
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "gl/graphics.h"

namespace shadowlab::lua {

/// One line for each state and place: "GL_BLEND_SRC_RGB[2] = 1". GL's own queries, not the table's.
class Snapshot {
 public:
  explicit Snapshot(const gl::Graphics& graphics) : graphics_(graphics) {
    load(get_floats_, "glGetFloatv");
    load(get_indexed_, "glGetIntegeri_v");
    load(is_enabled_indexed_, "glIsEnabledi");
    load(get_attribute_, "glGetVertexAttribfv");
    load(get_query_, "glGetQueryiv");
    load(get_texture_parameter_, "glGetTexParameteriv");
    load(active_texture_, "glActiveTexture");
    load(error_, "glGetError");
    take();
  }

  const std::vector<std::string>& lines() const { return lines_; }

 private:
  template <class F>
  void load(F& pointer, const char* name) {
    pointer = reinterpret_cast<F>(graphics_.context().function(name));
  }
  void add(std::string name, std::span<const GLfloat> values) {
    lines_.push_back(fmt::format("{} = {}", name, fmt::join(values, " ")));
  }
  void add_integer(std::string name, GLint value) {
    lines_.push_back(fmt::format("{} = {}", name, value));
  }
  void floats(GLenum name, const std::string& text) {
    std::array<GLfloat, 16> values{};
    get_floats_(name, values.data());
    add(text, values);
  }

  void take() {
    GLfloat unit = 0;
    get_floats_(GL_ACTIVE_TEXTURE, &unit);
    for (const gl::Constant& name : gl::StateName::values)
      floats(name.value, std::string(name.name));
    for (const gl::Constant& name : gl::Capability::values)
      floats(name.value, std::string(name.name));
    for (const GLenum name : {GL_CLIP_ORIGIN,
                              GL_CLIP_DEPTH_MODE,
                              GL_PROVOKING_VERTEX,
                              GL_POLYGON_MODE,
                              GL_LINE_WIDTH,
                              GL_POINT_SIZE,
                              GL_LOGIC_OP_MODE,
                              GL_PRIMITIVE_RESTART_INDEX,
                              GL_UNPACK_ALIGNMENT,
                              GL_PACK_ALIGNMENT,
                              GL_UNPACK_ROW_LENGTH,
                              GL_PACK_ROW_LENGTH,
                              GL_RENDERBUFFER_BINDING,
                              GL_DRAW_FRAMEBUFFER_BINDING,
                              GL_READ_FRAMEBUFFER_BINDING,
                              GL_VERTEX_ARRAY_BINDING,
                              GL_ELEMENT_ARRAY_BUFFER_BINDING,
                              GL_PIXEL_PACK_BUFFER_BINDING,
                              GL_PIXEL_UNPACK_BUFFER_BINDING,
                              GL_SAMPLE_COVERAGE_VALUE,
                              GL_SMOOTH_LINE_WIDTH_RANGE}) {
      floats(name, fmt::format("0x{:04X}", name));
    }
    for (GLenum i = 0; i < 8; ++i) floats(GL_DRAW_BUFFER0 + i, fmt::format("DRAW_BUFFER{}", i));
    indexed();
    textures();
    for (GLuint i = 0; i < 16; ++i) {
      std::array<GLfloat, 4> values{};
      get_attribute_(i, GL_CURRENT_VERTEX_ATTRIB, values.data());
      add(fmt::format("attribute {}", i), values);
      get_attribute_(i, GL_VERTEX_ATTRIB_ARRAY_ENABLED, values.data());
      add(fmt::format("attribute array {}", i), std::span(values).first(1));
    }
    for (const gl::Constant& target : gl::QueryTarget::values) {
      GLint query = 0;
      get_query_(target.value, GL_CURRENT_QUERY, &query);
      add_integer("query " + std::string(target.name), query);
    }
    active_texture_(static_cast<GLenum>(unit));
    // What this driver does not know of the above is no error of the state.
    while (error_() != GL_NO_ERROR) {
    }
  }

  void indexed() {
    for (GLuint i = 0; i < 8; ++i) {
      add_integer(fmt::format("BLEND[{}]", i), is_enabled_indexed_(GL_BLEND, i));
      add_integer(fmt::format("SCISSOR_TEST[{}]", i), is_enabled_indexed_(GL_SCISSOR_TEST, i));
      for (const GLenum name : {GL_BLEND_SRC_RGB, GL_BLEND_DST_RGB, GL_BLEND_SRC_ALPHA,
                                GL_BLEND_DST_ALPHA, GL_BLEND_EQUATION_RGB, GL_BLEND_EQUATION_ALPHA,
                                GL_COLOR_WRITEMASK, GL_SCISSOR_BOX, GL_VIEWPORT}) {
        std::array<GLint, 4> values{};
        get_indexed_(name, i, values.data());
        lines_.push_back(fmt::format("0x{:04X}[{}] = {}", name, i, fmt::join(values, " ")));
      }
    }
  }

  void textures() {
    constexpr std::pair<GLenum, GLenum> bindings[] = {
        {GL_TEXTURE_1D, GL_TEXTURE_BINDING_1D},
        {GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D},
        {GL_TEXTURE_3D, GL_TEXTURE_BINDING_3D},
        {GL_TEXTURE_CUBE_MAP, GL_TEXTURE_BINDING_CUBE_MAP},
        {GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BINDING_2D_ARRAY},
        {GL_TEXTURE_RECTANGLE, GL_TEXTURE_BINDING_RECTANGLE}};
    for (GLenum unit = 0; unit < 20; ++unit) {
      active_texture_(GL_TEXTURE0 + unit);
      floats(GL_SAMPLER_BINDING, fmt::format("sampler of unit {}", unit));
      for (const auto& [target, binding] : bindings) {
        GLfloat bound = 0;
        get_floats_(binding, &bound);
        add(fmt::format("0x{:04X} of unit {}", target, unit), {&bound, 1});
        if (bound != 0) continue;
        for (const GLenum parameter :
             {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER, GL_TEXTURE_WRAP_S,
              GL_TEXTURE_COMPARE_MODE, GL_TEXTURE_MAX_LEVEL, GL_TEXTURE_SWIZZLE_R}) {
          GLint value = 0;
          get_texture_parameter_(target, parameter, &value);
          add_integer(fmt::format("0x{:04X} of texture 0, 0x{:04X}", parameter, target), value);
        }
      }
    }
  }

  const gl::Graphics& graphics_;
  std::vector<std::string> lines_;
  void (*get_floats_)(GLenum, GLfloat*) = nullptr;
  void (*get_indexed_)(GLenum, GLuint, GLint*) = nullptr;
  GLboolean (*is_enabled_indexed_)(GLenum, GLuint) = nullptr;
  void (*get_attribute_)(GLuint, GLenum, GLfloat*) = nullptr;
  void (*get_query_)(GLenum, GLenum, GLint*) = nullptr;
  void (*get_texture_parameter_)(GLenum, GLenum, GLint*) = nullptr;
  void (*active_texture_)(GLenum) = nullptr;
  GLenum (*error_)() = nullptr;
};

/// What is in `after` and was not so in `before`.
inline std::string difference(const Snapshot& before, const Snapshot& after) {
  std::string text;
  for (std::size_t i = 0; i < before.lines().size(); ++i) {
    if (before.lines()[i] != after.lines()[i])
      text += before.lines()[i] + "  ->  " + after.lines()[i] + "\n";
  }
  return text;
}

}  // namespace shadowlab::lua
