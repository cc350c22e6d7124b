// What of a frame the studio shows: which pass, which buffer, which pixel.
#include <algorithm>
#include <cmath>
#include <utility>

#include "image/buffer_pictures.h"
#include "live/studio.h"

namespace shadowlab::live {
namespace {

image::Image stencil_picture(const std::vector<std::uint8_t>& stencil, int width, int height) {
  image::Image picture(width, height);
  for (std::size_t i = 0; i < stencil.size(); ++i) {
    std::ranges::copy(image::stencil_color(stencil[i]),
                      picture.rgba.begin() + static_cast<std::ptrdiff_t>(4 * i));
  }
  return picture;
}

// Numbers of any range as colours: those of [0, 1] as they are, others over their range.
image::Image attachment_picture(const gl::AttachmentContents& contents) {
  if (contents.name == "GL_STENCIL_ATTACHMENT") {
    std::vector<std::uint8_t> stencil(contents.values.size());
    std::ranges::transform(contents.values, stencil.begin(),
                           [](float v) { return static_cast<std::uint8_t>(v); });
    return stencil_picture(stencil, contents.width, contents.height);
  }
  if (contents.channels == 1)
    return image::depth_picture({contents.width, contents.height, contents.values});
  float low = 0, high = 1;
  for (std::size_t i = 0; i < contents.values.size(); ++i) {
    if (i % 4 == 3 || !std::isfinite(contents.values[i])) continue;
    low = std::min(low, contents.values[i]);
    high = std::max(high, contents.values[i]);
  }
  image::Image picture(contents.width, contents.height);
  for (std::size_t i = 0; i < contents.values.size(); ++i) {
    const float value = contents.values[i];
    const float part = std::isfinite(value) ? (value - low) / (high - low) : 1;
    if (i % 4 != 3) picture.rgba[i] = static_cast<std::uint8_t>(std::lround(255 * part));
  }
  return picture;
}

}  // namespace

void Studio::choose_pass(std::optional<PassName> pass) {
  chosen_ = std::move(pass);
  touch();
}

void Studio::step_pass(int by) {
  const auto& passes = inspector_.passes();
  if (passes.empty()) return;
  const auto count = static_cast<int>(passes.size());
  // The frame's end is the place before the first pass and after the last.
  int place = -1;
  for (int i = 0; i < count; ++i) {
    if (chosen_ == passes[static_cast<std::size_t>(i)].name) place = i;
  }
  place = (place + 1 + by + count + 1) % (count + 1) - 1;
  choose_pass(place < 0 ? std::nullopt
                        : std::optional(passes[static_cast<std::size_t>(place)].name));
}

void Studio::look_at(LookedAt what) {
  looked_at_ = what;
  touch();
}

void Studio::look_at_next() {
  using Buffer = LookedAt::Buffer;
  const std::size_t attachments = inspector_.buffers().attachments.size();
  LookedAt next = looked_at_;
  if (next.buffer == Buffer::attachment && next.attachment + 1 < attachments) {
    ++next.attachment;
  } else if (next.buffer == Buffer::attachment ||
             (next.buffer == Buffer::stencil && attachments == 0)) {
    next = {};
  } else {
    next = {static_cast<Buffer>(static_cast<int>(next.buffer) + 1), 0};
  }
  look_at(next);
}

void Studio::set_numbers(Numbers numbers) {
  if (std::exchange(numbers_, numbers) != numbers) touch();
}

void Studio::set_tracing(Tracing tracing) {
  if (tracing == tracing_) return;
  tracing_ = tracing;
  calls_.clear();
  touch();
}

void Studio::keep_calls() {
  constexpr std::size_t most = 1000;
  calls_.clear();
  int pass = -1;
  const auto& passes = inspector_.passes();
  for (std::size_t i = 0; i < passes.size(); ++i) {
    if (chosen_ == passes[i].name) pass = static_cast<int>(i);
  }
  for (std::size_t i = 0; i < recorder_.size() && calls_.size() < most; ++i) {
    const gl::TracedCall call = recorder_.call(i);
    if (chosen_ && call.pass != pass) continue;
    calls_.push_back(call.as_c() + (call.comment.empty() ? "" : "  // " + call.comment));
  }
}

void Studio::set_pixel(std::optional<glm::ivec2> pixel) {
  if (pixel == pixel_) return;
  pixel_ = pixel;
  touch();
}

const gl::ShownPicture& Studio::shown(const Bench& bench) const {
  return &bench == benches_[focus_].get() && buffer_shown_ ? buffer_picture_ : bench.picture;
}

void Studio::show_buffers() {
  using Buffer = LookedAt::Buffer;
  const Buffers& buffers = inspector_.buffers();
  const bool held = chosen_ && inspector_.kept_pass();
  buffer_shown_ = held || looked_at_.buffer != Buffer::color;
  buffer_ = {};
  if (!buffer_shown_) return;
  switch (looked_at_.buffer) {
    case Buffer::depth:
      buffer_ = image::depth_picture(buffers.depth);
      break;
    case Buffer::stencil:
      buffer_ = stencil_picture(buffers.stencil, graphics_.width(), graphics_.height());
      break;
    case Buffer::attachment:
      if (looked_at_.attachment < buffers.attachments.size()) {
        buffer_ = attachment_picture(buffers.attachments[looked_at_.attachment]);
        break;
      }
      [[fallthrough]];
    case Buffer::color:
      buffer_picture_.upload(buffers.color);
      return;
  }
  buffer_picture_.upload(buffer_);
}

bool Studio::is_light_at(std::size_t pixel) const {
  const auto& rgba = buffer_.rgba.empty() ? inspector_.buffers().color.rgba : buffer_.rgba;
  if (4 * pixel + 2 >= rgba.size()) return false;
  // Luma as of Rec. 709, of the bytes as they are: what an eye takes for half is not half the
  // light.
  const double luma =
      0.2126 * rgba[4 * pixel] + 0.7152 * rgba[4 * pixel + 1] + 0.0722 * rgba[4 * pixel + 2];
  return luma > 127;
}

}  // namespace shadowlab::live
