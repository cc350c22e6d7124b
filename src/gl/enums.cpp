#include "gl/enums.h"

#include <algorithm>
#include <vector>

namespace shadowlab::gl {
namespace {

template <class... Kinds>
std::vector<Constant> gather() {
  std::vector<Constant> all;
  const auto add = [&all](std::span<const Constant> values) {
    for (const Constant& constant : values) {
      const auto same = [&](const Constant& other) { return other.name == constant.name; };
      if (std::none_of(all.begin(), all.end(), same)) all.push_back(constant);
    }
  };
  (add(Kinds::values), ...);
  return all;
}

}  // namespace

std::span<const Constant> all_constants() {
  static const std::vector<Constant> all =
      gather<CompareFunction, StencilAction, Face, Winding, BothFaces, FillMode,
             ProvokingConvention, ClipOrigin, ClipDepth, LogicOperation, Capability,
             IndexedCapability, BlendEquationName, BlendFactor, AccumOperation, TextureUnit,
             TextureTarget, ImageTarget2D, StorageTarget2D, ImageTarget3D, TextureParameter,
             SamplerParameter, TextureParameterValue, InternalFormat, PixelFormat, PixelType,
             PixelStoreName, FramebufferTarget, RenderbufferTarget, Attachment, ColorBuffer,
             ClearedBuffer, ClearedDepthStencil, BlitFilter, FramebufferStatus, AttachmentParameter,
             RenderbufferParameter, BufferTarget, BufferUsage, AttributeType, IndexType, Primitive,
             ShaderStage, ShaderParameter, ProgramParameter, QueryTarget, QueryParameter, ErrorCode,
             Truth, StateName, ClearBits, BlitBits>();
  return all;
}

int state_size(GLenum name) {
  switch (name) {
    case GL_BLEND_COLOR:
    case GL_COLOR_CLEAR_VALUE:
    case GL_COLOR_WRITEMASK:
    case GL_SCISSOR_BOX:
    case GL_VIEWPORT:
      return 4;
    case GL_DEPTH_RANGE:
    case GL_MAX_VIEWPORT_DIMS:
      return 2;
    default:
      return 1;
  }
}

}  // namespace shadowlab::gl
