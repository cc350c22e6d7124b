#include "live/inspector.h"

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

namespace shadowlab::live {

std::vector<PassName> names_of(std::span<const recipe::PassTime> passes) {
  std::vector<PassName> names;
  std::map<std::string_view, int> occurrences;
  for (const recipe::PassTime& pass : passes)
    names.push_back({pass.name, occurrences[pass.name]++});
  return names;
}

void Inspector::attach(recipe::Recipe& recipe) {
  recipe.on_pass_end([this, &recipe](std::size_t index) { pass_ended(recipe, index); });
}

void Inspector::begin(Wanted wanted) {
  wanted_ = std::move(wanted);
  looking_ = true;
  expected_.reset();
  for (std::size_t i = 0; wanted_.pass && i < passes_.size(); ++i) {
    if (passes_[i].name == *wanted_.pass) expected_ = i;
  }
  seen_.clear();
  seen_before_.reset();
  drawn_.reset();
  framebuffers_.clear();
  seen_kept_.reset();
  seen_buffers_ = {};
  const bool inside = wanted_.pixel && wanted_.pixel->x >= 0 && wanted_.pixel->y >= 0 &&
                      wanted_.pixel->x < graphics_.width() && wanted_.pixel->y < graphics_.height();
  if (!inside) wanted_.pixel.reset();
  if (wanted_.pixel) seen_before_ = graphics_.frame.read_pixel(wanted_.pixel->x, wanted_.pixel->y);
  graphics_.calls().draws = this;
}

void Inspector::stop() {
  looking_ = false;
  graphics_.calls().draws = nullptr;
}

void Inspector::finish(const recipe::Recipe& recipe) {
  if (!looking_) return;
  if (wanted_.buffer && !seen_kept_) {
    framebuffers_.clear();
    keep_buffers();
  }
  stop();
  const auto passes = recipe.passes();
  for (std::size_t i = 0; i < seen_.size() && i < passes.size(); ++i) {
    seen_[i].milliseconds = passes[i].milliseconds;
    seen_[i].work = passes[i].work;
  }
  std::swap(passes_, seen_);
  std::swap(before_, seen_before_);
  kept_ = seen_kept_;
  if (wanted_.buffer) std::swap(buffers_, seen_buffers_);
}

bool Inspector::missed_state() const {
  return std::ranges::any_of(
      passes_, [this](const PassReport& pass) { return wanted_.pass == pass.name && !pass.state; });
}

// Asking for all of the state at every draw would cost as much as small draws do.
bool Inspector::wants_state() const {
  return expected_ && (seen_.size() == *expected_ || seen_.size() + 1 == *expected_);
}

void Inspector::before_draw(const std::function<void()>&) {
  if (!wants_state()) return;
  drawn_ = gl::state_now(graphics_.gl);
  const auto framebuffer = static_cast<GLuint>(drawn_->framebuffers[0]);
  if (framebuffer != graphics_.calls().main_frame &&
      std::ranges::find(framebuffers_, framebuffer) == framebuffers_.end())
    framebuffers_.push_back(framebuffer);
}

void Inspector::keep_buffers() {
  using Buffer = LookedAt::Buffer;
  seen_buffers_ = {};
  auto& attachments = seen_buffers_.attachments;
  const auto [buffer, wanted] = *wanted_.buffer;
  for (const GLuint framebuffer : framebuffers_) {
    std::optional<std::size_t> here;
    if (buffer == Buffer::attachment && wanted >= attachments.size())
      here = wanted - attachments.size();
    for (auto& contents : gl::read_attachments(graphics_.gl, framebuffer, here))
      attachments.push_back(std::move(contents));
  }
  if (buffer == Buffer::depth) {
    seen_buffers_.depth = graphics_.frame.read_depth();
  } else if (buffer == Buffer::stencil) {
    seen_buffers_.stencil = graphics_.frame.read_stencil();
  } else if (buffer == Buffer::color || wanted >= attachments.size()) {
    seen_buffers_.color = graphics_.frame.read_color();
  }
}

void Inspector::pass_ended(const recipe::Recipe& recipe, std::size_t index) {
  if (!looking_) return;
  const auto passes = recipe.passes();
  const std::string& name = passes[index].name;
  const auto occurrence = static_cast<int>(std::ranges::count_if(
      seen_, [&](const PassReport& report) { return report.name.name == name; }));
  PassReport report{{name, occurrence}, 0, {}, {}, {}};
  if (wants_state()) report.state = drawn_ ? std::move(*drawn_) : gl::state_now(graphics_.gl);
  drawn_.reset();
  if (wanted_.pixel) report.pixel = graphics_.frame.read_pixel(wanted_.pixel->x, wanted_.pixel->y);
  if (wanted_.buffer && wanted_.pass == report.name) {
    keep_buffers();
    seen_kept_ = index;
  }
  framebuffers_.clear();
  seen_.push_back(std::move(report));
}

}  // namespace shadowlab::live
