#include "gl/state.h"

#include <algorithm>
#include <span>

#include "gl/get.h"

namespace shadowlab::gl {
namespace {

// Off by default, all but these two (OpenGL 4.5, tables 23.11 to 23.16).
bool on_by_default(GLenum capability) {
  return capability == GL_DITHER || capability == GL_MULTISAMPLE;
}

// What would change a full-screen pass. Blending is switched for the first draw buffer alone,
// which is all that the pass has, and scissoring by the box: both are switches in several places.
constexpr std::array pass_capabilities{GL_COLOR_LOGIC_OP,     GL_CULL_FACE,
                                       GL_DEPTH_TEST,         GL_STENCIL_TEST,
                                       GL_RASTERIZER_DISCARD, GL_SAMPLE_ALPHA_TO_COVERAGE,
                                       GL_CLIP_DISTANCE0,     GL_CLIP_DISTANCE1,
                                       GL_CLIP_DISTANCE2,     GL_CLIP_DISTANCE3};
constexpr GLuint texture_units = TextureUnit::values.size();
constexpr GLsizei largest = 16384;  // side of a main frame

}  // namespace

std::vector<GLenum> active_queries(const Functions& gl) {
  std::vector<GLenum> targets;
  for (const Constant& target : QueryTarget::values) {
    GLint query = 0;
    gl.GetQueryiv.unrecorded(target.value, GL_CURRENT_QUERY, {&query, 1});
    if (query != 0) targets.push_back(target.value);
  }
  return targets;
}

void reset_state(const Functions& gl, int width, int height) {
  for (const GLenum target : active_queries(gl)) gl.EndQuery.unrecorded(target);
  gl.BindFramebuffer.unrecorded(GL_FRAMEBUFFER, 0);
  gl.BindRenderbuffer.unrecorded(GL_RENDERBUFFER, 0);
  gl.DrawBuffers.unrecorded(1, std::array<GLenum, 1>{GL_BACK});
  gl.ReadBuffer.unrecorded(GL_BACK);
  gl.UseProgram.unrecorded(0);
  gl.BindVertexArray.unrecorded(0);
  gl.BindBuffer.unrecorded(GL_ARRAY_BUFFER, 0);
  for (GLuint unit = texture_units; unit-- > 0;) {
    gl.ActiveTexture.unrecorded(GL_TEXTURE0 + unit);
    for (const Constant& target : TextureTarget::values) gl.BindTexture.unrecorded(target.value, 0);
    gl.BindSampler.unrecorded(unit, 0);
  }
  for (const Constant& capability : Capability::values) {
    if (on_by_default(capability.value)) {
      gl.Enable.unrecorded(capability.value);
    } else {
      gl.Disable.unrecorded(capability.value);
    }
  }
  gl.Viewport.unrecorded(0, 0, width, height);
  gl.Scissor.unrecorded(0, 0, width, height);
  gl.ClearColor.unrecorded(0, 0, 0, 0);
  gl.ClearDepth.unrecorded(1);
  gl.ClearStencil.unrecorded(0);
  gl.ColorMask.unrecorded(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.DepthMask.unrecorded(GL_TRUE);
  gl.StencilMask.unrecorded(~0u);
  gl.DepthFunc.unrecorded(GL_LESS);
  gl.DepthRange.unrecorded(0, 1);
  gl.StencilFunc.unrecorded(GL_ALWAYS, 0, ~0u);
  gl.StencilOp.unrecorded(GL_KEEP, GL_KEEP, GL_KEEP);
  gl.BlendFunc.unrecorded(GL_ONE, GL_ZERO);
  gl.BlendEquation.unrecorded(GL_FUNC_ADD);
  gl.BlendColor.unrecorded(0, 0, 0, 0);
  gl.LogicOp.unrecorded(GL_COPY);
  gl.CullFace.unrecorded(GL_BACK);
  gl.FrontFace.unrecorded(GL_CCW);
  gl.PolygonMode.unrecorded(GL_FRONT_AND_BACK, GL_FILL);
  gl.PolygonOffset.unrecorded(0, 0);
  gl.LineWidth.unrecorded(1);
  gl.PointSize.unrecorded(1);
  gl.ProvokingVertex.unrecorded(GL_LAST_VERTEX_CONVENTION);
  gl.PrimitiveRestartIndex.unrecorded(0);
  if (gl.ClipControl) gl.ClipControl.unrecorded(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
  gl.PixelStorei.unrecorded(GL_UNPACK_ALIGNMENT, 4);
  gl.PixelStorei.unrecorded(GL_PACK_ALIGNMENT, 4);
  for (GLuint index = 0; index < 16; ++index) gl.VertexAttrib4f.unrecorded(index, 0, 0, 0, 1);
}

SavedState::SavedState(const Functions& gl) : gl_(gl) {
  for (const GLenum capability : pass_capabilities) {
    if (gl.IsEnabled.unrecorded(capability)) enabled_.push_back(capability);
    gl.Disable.unrecorded(capability);
  }
  blended_ = gl.IsEnabledi.unrecorded(GL_BLEND, 0);
  gl.Disablei.unrecorded(GL_BLEND, 0);
  scissored_ = gl.IsEnabled.unrecorded(GL_SCISSOR_TEST);
  gl.GetIntegerv.unrecorded(GL_SCISSOR_BOX, scissor_);
  gl.Scissor.unrecorded(0, 0, largest, largest);
  gl.GetIntegerv.unrecorded(GL_VIEWPORT, viewport_);
  gl.GetBooleanv.unrecorded(GL_COLOR_WRITEMASK, color_mask_);
  gl.ColorMaski.unrecorded(0, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  polygon_mode_ = integer(gl, GL_POLYGON_MODE);
  gl.PolygonMode.unrecorded(GL_FRONT_AND_BACK, GL_FILL);
  unit_ = integer(gl, GL_ACTIVE_TEXTURE);
  for (GLuint unit = 0; unit < bound_.size(); ++unit) {
    gl.ActiveTexture.unrecorded(GL_TEXTURE0 + unit);
    bound_[unit] = {integer(gl, GL_TEXTURE_BINDING_2D), integer(gl, GL_SAMPLER_BINDING)};
    gl.BindSampler.unrecorded(unit, 0);
  }
  program_ = integer(gl, GL_CURRENT_PROGRAM);
  vertex_array_ = integer(gl, GL_VERTEX_ARRAY_BINDING);
  draw_framebuffer_ = integer(gl, GL_DRAW_FRAMEBUFFER_BINDING);
  read_framebuffer_ = integer(gl, GL_READ_FRAMEBUFFER_BINDING);
  read_buffer_ = integer(gl, GL_READ_BUFFER);
}

SavedState::~SavedState() {
  const auto name = [](GLint value) { return static_cast<GLuint>(value); };
  gl_.BindFramebuffer.unrecorded(GL_DRAW_FRAMEBUFFER, name(draw_framebuffer_));
  gl_.BindFramebuffer.unrecorded(GL_READ_FRAMEBUFFER, name(read_framebuffer_));
  gl_.BindVertexArray.unrecorded(name(vertex_array_));
  gl_.UseProgram.unrecorded(name(program_));
  for (GLuint unit = 0; unit < bound_.size(); ++unit) {
    gl_.ActiveTexture.unrecorded(GL_TEXTURE0 + unit);
    gl_.BindTexture.unrecorded(GL_TEXTURE_2D, name(bound_[unit][0]));
    gl_.BindSampler.unrecorded(unit, name(bound_[unit][1]));
  }
  gl_.ActiveTexture.unrecorded(name(unit_));
  gl_.PolygonMode.unrecorded(GL_FRONT_AND_BACK, name(polygon_mode_));
  gl_.ColorMaski.unrecorded(0, color_mask_[0], color_mask_[1], color_mask_[2], color_mask_[3]);
  gl_.Viewport.unrecorded(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
  gl_.Scissor.unrecorded(scissor_[0], scissor_[1], scissor_[2], scissor_[3]);
  if (blended_) gl_.Enablei.unrecorded(GL_BLEND, 0);
  for (const GLenum capability : enabled_) gl_.Enable.unrecorded(capability);
}

bool SavedState::discards_rasterization() const {
  return std::find(enabled_.begin(), enabled_.end(), GL_RASTERIZER_DISCARD) != enabled_.end();
}

std::optional<std::array<GLint, 4>> SavedState::scissor() const {
  return scissored_ ? std::optional(scissor_) : std::nullopt;
}

}  // namespace shadowlab::gl
