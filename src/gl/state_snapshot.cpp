#include "gl/state_snapshot.h"

#include <fmt/format.h>

#include <string_view>

#include "gl/get.h"

namespace shadowlab::gl {
namespace {

template <std::size_t N>
std::array<GLint, N> integers(const Functions& gl, GLenum name) {
  std::array<GLint, 16> values{};
  gl.GetIntegerv.unrecorded(name, values);
  std::array<GLint, N> first{};
  std::copy_n(values.begin(), N, first.begin());
  return first;
}

template <std::size_t N>
std::array<GLfloat, N> floats(const Functions& gl, GLenum name) {
  std::array<GLfloat, N> values{};
  gl.GetFloatv.unrecorded(name, values);
  return values;
}

template <class Kind>
std::string name(GLint value) {
  for (const Constant& constant : Kind::values) {
    if (constant.value == static_cast<GLenum>(value)) return fmt::format("GL_{}", constant.name);
  }
  return fmt::format("0x{:04X}", value);
}

std::string c_float(GLfloat value) {
  std::string text = fmt::format("{}", value);
  if (text.find_first_of(".en") == std::string::npos) text += ".0";
  return text + "f";
}

const char* c_bool(GLboolean value) { return value ? "GL_TRUE" : "GL_FALSE"; }

using Face = StateSnapshot::StencilFace;

void add_stencil(std::vector<std::string>& lines, const std::array<Face, 2>& faces) {
  // The stencil has 8 bits; of a mask with all 32 GL tells a signed number's most.
  const auto bits = [](GLint mask) { return static_cast<GLuint>(mask) & 0xFFu; };
  const auto func = [&](const Face& f) {
    return fmt::format("{}, {}, 0x{:02X}", name<CompareFunction>(f.func), f.ref,
                       bits(f.value_mask));
  };
  const auto op = [](const Face& f) {
    return fmt::format("{}, {}, {}", name<StencilAction>(f.fail), name<StencilAction>(f.depth_fail),
                       name<StencilAction>(f.depth_pass));
  };
  const auto mask = [&](const Face& f) { return fmt::format("0x{:02X}", bits(f.write_mask)); };
  // Two lines a function: one call for both faces, or one for each.
  const auto add = [&](const char* function, const auto& arguments) {
    const std::string front = arguments(faces[0]), back = arguments(faces[1]);
    if (front == back) {
      lines.push_back(fmt::format("glStencil{}({});", function, front));
      lines.emplace_back();
    } else {
      lines.push_back(fmt::format("glStencil{}Separate(GL_FRONT, {});", function, front));
      lines.push_back(fmt::format("glStencil{}Separate(GL_BACK, {});", function, back));
    }
  };
  add("Func", func);
  add("Op", op);
  add("Mask", mask);
}

void add_blending(std::vector<std::string>& lines, const StateSnapshot& state) {
  const auto factor = [&](std::size_t i) { return name<BlendFactor>(state.blend[i]); };
  const bool one = state.blend[0] == state.blend[2] && state.blend[1] == state.blend[3];
  lines.push_back(one ? fmt::format("glBlendFunc({}, {});", factor(0), factor(1))
                      : fmt::format("glBlendFuncSeparate({}, {}, {}, {});", factor(0), factor(1),
                                    factor(2), factor(3)));
  const auto equation = [&](std::size_t i) {
    return name<BlendEquationName>(state.blend_equation[i]);
  };
  lines.push_back(state.blend_equation[0] == state.blend_equation[1]
                      ? fmt::format("glBlendEquation({});", equation(0))
                      : fmt::format("glBlendEquationSeparate({}, {});", equation(0), equation(1)));
  const auto& color = state.blend_color;
  lines.push_back(fmt::format("glBlendColor({}, {}, {}, {});", c_float(color[0]), c_float(color[1]),
                              c_float(color[2]), c_float(color[3])));
}

void add_textures(std::vector<std::string>& lines, const StateSnapshot& state) {
  for (std::size_t unit = 0; unit < state.texture_2d.size(); ++unit) {
    const auto line = [&](const char* target, GLint texture) {
      return texture == 0
                 ? std::string()
                 : fmt::format("glActiveTexture(GL_TEXTURE{}); glBindTexture({}, texture_{});",
                               unit, target, texture);
    };
    lines.push_back(line("GL_TEXTURE_2D", state.texture_2d[unit]));
    lines.push_back(line("GL_TEXTURE_CUBE_MAP", state.texture_cube[unit]));
  }
}

}  // namespace

StateSnapshot state_now(const Functions& gl) {
  StateSnapshot state;
  for (const Constant& capability : Capability::values)
    state.enabled.push_back(gl.IsEnabled.unrecorded(capability.value));
  const auto get = [&gl](GLenum what) { return integer(gl, what); };
  state.stencil[0] = {get(GL_STENCIL_FUNC),
                      get(GL_STENCIL_REF),
                      get(GL_STENCIL_VALUE_MASK),
                      get(GL_STENCIL_FAIL),
                      get(GL_STENCIL_PASS_DEPTH_FAIL),
                      get(GL_STENCIL_PASS_DEPTH_PASS),
                      get(GL_STENCIL_WRITEMASK)};
  state.stencil[1] = {get(GL_STENCIL_BACK_FUNC),
                      get(GL_STENCIL_BACK_REF),
                      get(GL_STENCIL_BACK_VALUE_MASK),
                      get(GL_STENCIL_BACK_FAIL),
                      get(GL_STENCIL_BACK_PASS_DEPTH_FAIL),
                      get(GL_STENCIL_BACK_PASS_DEPTH_PASS),
                      get(GL_STENCIL_BACK_WRITEMASK)};
  state.depth_func = get(GL_DEPTH_FUNC);
  state.cull_face = get(GL_CULL_FACE_MODE);
  state.front_face = get(GL_FRONT_FACE);
  state.logic_op = get(GL_LOGIC_OP_MODE);
  state.program = get(GL_CURRENT_PROGRAM);
  state.polygon_mode = integers<2>(gl, GL_POLYGON_MODE);
  state.framebuffers = {get(GL_DRAW_FRAMEBUFFER_BINDING), get(GL_READ_FRAMEBUFFER_BINDING)};
  state.blend = {get(GL_BLEND_SRC_RGB), get(GL_BLEND_DST_RGB), get(GL_BLEND_SRC_ALPHA),
                 get(GL_BLEND_DST_ALPHA)};
  state.blend_equation = {get(GL_BLEND_EQUATION_RGB), get(GL_BLEND_EQUATION_ALPHA)};
  gl.GetBooleanv.unrecorded(GL_COLOR_WRITEMASK, state.color_mask);
  gl.GetBooleanv.unrecorded(GL_DEPTH_WRITEMASK, {&state.depth_mask, 1});
  state.depth_range = floats<2>(gl, GL_DEPTH_RANGE);
  state.polygon_offset = {floats<1>(gl, GL_POLYGON_OFFSET_FACTOR)[0],
                          floats<1>(gl, GL_POLYGON_OFFSET_UNITS)[0]};
  state.line_width = floats<1>(gl, GL_LINE_WIDTH)[0];
  state.point_size = floats<1>(gl, GL_POINT_SIZE)[0];
  state.blend_color = floats<4>(gl, GL_BLEND_COLOR);
  state.viewport = integers<4>(gl, GL_VIEWPORT);
  state.scissor = integers<4>(gl, GL_SCISSOR_BOX);
  const GLint unit = get(GL_ACTIVE_TEXTURE);
  for (std::size_t i = 0; i < state.texture_2d.size(); ++i) {
    gl.ActiveTexture.unrecorded(GL_TEXTURE0 + static_cast<GLenum>(i));
    state.texture_2d[i] = get(GL_TEXTURE_BINDING_2D);
    state.texture_cube[i] = get(GL_TEXTURE_BINDING_CUBE_MAP);
  }
  gl.ActiveTexture.unrecorded(static_cast<GLenum>(unit));
  return state;
}

std::vector<std::string> as_c(const StateSnapshot& state, GLuint main_frame) {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < state.enabled.size(); ++i) {
    lines.push_back(fmt::format("gl{}(GL_{});", state.enabled[i] ? "Enable" : "Disable",
                                Capability::values[i].name));
  }
  const auto framebuffer = [&](GLint bound) {
    return static_cast<GLuint>(bound) == main_frame ? std::string("0")
                                                    : fmt::format("framebuffer_{}", bound);
  };
  lines.push_back(fmt::format("glBindFramebuffer(GL_DRAW_FRAMEBUFFER, {});",
                              framebuffer(state.framebuffers[0])));
  lines.push_back(fmt::format("glDepthFunc({});", name<CompareFunction>(state.depth_func)));
  lines.push_back(fmt::format("glDepthMask({});", c_bool(state.depth_mask)));
  lines.push_back(fmt::format("glDepthRange({}, {});", state.depth_range[0], state.depth_range[1]));
  add_stencil(lines, state.stencil);
  const auto& mask = state.color_mask;
  lines.push_back(fmt::format("glColorMask({}, {}, {}, {});", c_bool(mask[0]), c_bool(mask[1]),
                              c_bool(mask[2]), c_bool(mask[3])));
  add_blending(lines, state);
  lines.push_back(fmt::format("glCullFace({});", name<gl::Face>(state.cull_face)));
  lines.push_back(fmt::format("glFrontFace({});", name<Winding>(state.front_face)));
  lines.push_back(
      fmt::format("glPolygonMode(GL_FRONT_AND_BACK, {});", name<FillMode>(state.polygon_mode[0])));
  lines.push_back(fmt::format("glPolygonOffset({}, {});", c_float(state.polygon_offset[0]),
                              c_float(state.polygon_offset[1])));
  lines.push_back(fmt::format("glLineWidth({});", c_float(state.line_width)));
  lines.push_back(fmt::format("glPointSize({});", c_float(state.point_size)));
  lines.push_back(fmt::format("glLogicOp({});", name<LogicOperation>(state.logic_op)));
  const auto box = [](const char* function, const std::array<GLint, 4>& b) {
    return fmt::format("gl{}({}, {}, {}, {});", function, b[0], b[1], b[2], b[3]);
  };
  lines.push_back(box("Viewport", state.viewport));
  lines.push_back(box("Scissor", state.scissor));
  lines.push_back(state.program == 0 ? "glUseProgram(0);"
                                     : fmt::format("glUseProgram(program_{});", state.program));
  add_textures(lines, state);
  return lines;
}

}  // namespace shadowlab::gl
