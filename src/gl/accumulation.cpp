#include "gl/accumulation.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.h"
#include "gl/accumulation_shaders.h"
#include "gl/state.h"

namespace shadowlab::gl {
namespace {

struct StorageFormat {
  const char* name;
  int bits;
  int half;  // integers wrap around in [-half, half); 1.0 is half - 1
  GLenum internal, format, type;
};

constexpr std::array<StorageFormat, 4> formats{{
    {"snorm8", 8, 128, GL_RGBA8I, GL_RGBA_INTEGER, GL_BYTE},
    {"snorm16", 16, 32768, GL_RGBA16I, GL_RGBA_INTEGER, GL_SHORT},
    {"float16", 16, 0, GL_RGBA16F, GL_RGBA, GL_FLOAT},
    {"float32", 32, 0, GL_RGBA32F, GL_RGBA, GL_FLOAT},
}};

const StorageFormat& format_of(AccumStorage storage) {
  return formats[static_cast<std::size_t>(storage)];
}

// C's conversion of an out-of-range float is undefined; what x86 gives (and Mesa therefore shows)
// is the lowest integer, whose low bits are 0.
int truncated(float value) { return std::abs(value) < 2147483648.0f ? static_cast<int>(value) : 0; }

int wrapped(int value, int half) {
  const auto mask = static_cast<unsigned>(2 * half - 1);
  return static_cast<int>((static_cast<unsigned>(value) + static_cast<unsigned>(half)) & mask) -
         half;
}

}  // namespace

const char* name_of(AccumStorage storage) { return format_of(storage).name; }

int bits_of(AccumStorage storage) { return format_of(storage).bits; }

AccumStorage accum_storage_named(std::string_view name) {
  for (std::size_t i = 0; i < formats.size(); ++i) {
    if (name == formats[i].name) return static_cast<AccumStorage>(i);
  }
  throw InputError(
      "the accumulation buffer's storage is snorm8, snorm16, float16 or float32, not " +
      std::string(name));
}

Accumulation::Accumulation(const Functions& gl, CallContext& context, const MainFrame& frame,
                           ProgramCache& programs)
    : gl_(gl), context_(context), frame_(frame), programs_(programs) {}

Accumulation::~Accumulation() {
  release();
  if (table_) gl_.DeleteTextures.unrecorded(1, {&table_, 1});
  if (vertex_array_) gl_.DeleteVertexArrays.unrecorded(1, {&vertex_array_, 1});
}

void Accumulation::release() {
  if (!textures_[0]) return;
  gl_.DeleteFramebuffers.unrecorded(2, framebuffers_);
  gl_.DeleteTextures.unrecorded(2, textures_);
  textures_ = {};
  framebuffers_ = {};
}

void Accumulation::choose(AccumStorage storage) {
  if (storage == storage_) return;
  storage_ = storage;
  release();
}

void Accumulation::begin_frame() {
  choose(AccumStorage::snorm16);
  clear_value_ = {};
}

// Called within a SavedState, whose texture units it uses.
void Accumulation::allocate() {
  if (textures_[0]) return;
  if (!vertex_array_) gl_.GenVertexArrays.unrecorded(1, {&vertex_array_, 1});
  const StorageFormat& format = format_of(storage_);
  gl_.GenTextures.unrecorded(2, textures_);
  gl_.GenFramebuffers.unrecorded(2, framebuffers_);
  for (std::size_t i = 0; i < 2; ++i) {
    gl_.BindTexture.unrecorded(GL_TEXTURE_2D, textures_[i]);
    gl_.TexImage2D.unrecorded(GL_TEXTURE_2D, 0, format.internal, frame_.width(), frame_.height(), 0,
                              format.format, format.type, {});
    gl_.TexParameteri.unrecorded(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl_.TexParameteri.unrecorded(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl_.BindFramebuffer.unrecorded(GL_FRAMEBUFFER, framebuffers_[i]);
    gl_.FramebufferTexture2D.unrecorded(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                                        textures_[i], 0);
    if (integral()) {
      gl_.ClearBufferiv.unrecorded(GL_COLOR, 0, std::array<GLint, 4>{});
    } else {
      gl_.ClearBufferfv.unrecorded(GL_COLOR, 0, std::array<GLfloat, 4>{});
    }
  }
  current_ = 0;
}

void Accumulation::clear() {
  const Untraced untraced(context_);
  const SavedState saved(gl_);
  if (saved.discards_rasterization() || saved.draw_framebuffer() != context_.main_frame) return;
  allocate();
  gl_.BindFramebuffer.unrecorded(GL_FRAMEBUFFER, framebuffers_[current_]);
  if (const auto box = saved.scissor()) set_scissor(*box);
  if (integral()) {
    // OpenGL 2.1, table 2.9: 1.0 is the largest integer and -1.0 the smallest, one unit below its
    // negative; rounded as Mesa rounds.
    std::array<GLint, 4> value{};
    const auto range = static_cast<float>(2 * format_of(storage_).half - 1);
    for (std::size_t i = 0; i < 4; ++i) {
      value[i] = (static_cast<int>(range * std::clamp(clear_value_[i], -1.0f, 1.0f)) - 1) / 2;
    }
    gl_.ClearBufferiv.unrecorded(GL_COLOR, 0, value);
  } else {
    gl_.ClearBufferfv.unrecorded(GL_COLOR, 0, clear_value_);
  }
}

void Accumulation::run(GLenum operation, GLfloat value) {
  for (const GLenum query : active_queries(gl_)) {
    if (query == GL_TIME_ELAPSED) continue;
    throw InputError("the query that is under way would count the accumulation; end it first");
  }
  const Untraced untraced(context_);
  const SavedState saved(gl_);
  if (saved.draw_framebuffer() != context_.main_frame ||
      saved.read_framebuffer() != context_.main_frame) {
    throw InputError(
        "only the main frame has an accumulation buffer; call "
        "gl.BindFramebuffer(gl.FRAMEBUFFER, 0) first");
  }
  if (saved.discards_rasterization()) return;
  const bool reads_color = operation == GL_ACCUM || operation == GL_LOAD;
  if (reads_color && saved.read_buffer() == GL_NONE) return;
  allocate();
  gl_.BindVertexArray.unrecorded(vertex_array_);
  const std::array<GLint, 4> box =
      saved.scissor().value_or(std::array<GLint, 4>{0, 0, frame_.width(), frame_.height()});
  if (operation == GL_RETURN) {
    const auto mask = saved.color_mask();
    gl_.BindFramebuffer.unrecorded(GL_DRAW_FRAMEBUFFER, 0);
    gl_.ColorMaski.unrecorded(0, mask[0], mask[1], mask[2], mask[3]);
    set_scissor(box);
    give_back(value);
  } else {
    accumulate(operation, value, box);
  }
}

void Accumulation::set_scissor(const std::array<GLint, 4>& box) {
  gl_.Scissor.unrecorded(box[0], box[1], box[2], box[3]);
}

void Accumulation::upload_table(GLfloat value) {
  const int half = format_of(storage_).half;
  const float scale = value * static_cast<float>(half - 1);
  std::array<GLint, 256> added{};
  for (int c = 0; c < 256; ++c) {
    const float color = static_cast<float>(c) * (1.0f / 255.0f);  // not c / 255: Mesa's rounding
    added[static_cast<std::size_t>(c)] = wrapped(truncated(color * scale), half);
  }
  const bool created = table_ == 0;
  if (created) gl_.GenTextures.unrecorded(1, {&table_, 1});
  gl_.BindTexture.unrecorded(GL_TEXTURE_2D, table_);
  gl_.TexImage2D.unrecorded(GL_TEXTURE_2D, 0, GL_R32I, 256, 1, 0, GL_RED_INTEGER, GL_INT,
                            std::as_bytes(std::span(added)));
  if (!created) return;
  gl_.TexParameteri.unrecorded(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl_.TexParameteri.unrecorded(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

void Accumulation::accumulate(GLenum operation, GLfloat value, std::array<GLint, 4> box) {
  const int step = operation == GL_ACCUM  ? 0
                   : operation == GL_LOAD ? 1
                   : operation == GL_ADD  ? 2
                                          : 3;
  const auto one = static_cast<float>(format_of(storage_).half - 1);
  gl_.BindFramebuffer.unrecorded(GL_FRAMEBUFFER, framebuffers_[1 - current_]);
  gl_.Viewport.unrecorded(0, 0, frame_.width(), frame_.height());
  gl_.ActiveTexture.unrecorded(GL_TEXTURE2);
  if (integral() && step < 2) upload_table(value);
  gl_.ActiveTexture.unrecorded(GL_TEXTURE1);
  gl_.BindTexture.unrecorded(GL_TEXTURE_2D, frame_.color());
  gl_.ActiveTexture.unrecorded(GL_TEXTURE0);
  gl_.BindTexture.unrecorded(GL_TEXTURE_2D, textures_[current_]);
  draw({{"accumulation", triangle_over_all},
        {"accumulation", integral() ? integer_step : float_step},
        {}},
       {{"accumulated", {0}},
        {"color", {1}},
        {"table", {2}},
        {"operation", {static_cast<double>(step)}},
        {"bias", {static_cast<double>(truncated(value * one))}},
        {"factor", {value}},
        {"half_range", {static_cast<double>(format_of(storage_).half)}},
        {"box", {box.begin(), box.end()}}});
  current_ = 1 - current_;
}

void Accumulation::give_back(GLfloat value) {
  const float one = integral() ? static_cast<float>(format_of(storage_).half - 1) : 1.0f;
  gl_.Viewport.unrecorded(0, 0, frame_.width(), frame_.height());
  gl_.ActiveTexture.unrecorded(GL_TEXTURE0);
  gl_.BindTexture.unrecorded(GL_TEXTURE_2D, textures_[current_]);
  draw({{"accumulation", triangle_over_all}, {"accumulation", give_back_text(integral())}, {}},
       {{"accumulated", {0}}, {"factor", {value / one}}});
}

void Accumulation::draw(const ProgramSource& source, const Values& values) {
  Shader shader(programs_.get(source));
  for (const auto& [name, components] : values) {
    // The float steps have fewer uniforms than the integer one.
    if (const Uniform* uniform = shader.program().find(name)) shader.set(*uniform, components);
  }
  shader.use();
  gl_.DrawArrays.unrecorded(GL_TRIANGLES, 0, 3);
}

}  // namespace shadowlab::gl
