#include "live/workshop.h"

#include <algorithm>
#include <cstdlib>
#include <new>
#include <utility>

#include "core/error.h"

namespace shadowlab::live {
namespace {

std::string sentence_of(const std::exception& problem) {
  if (dynamic_cast<const std::bad_alloc*>(&problem))
    return "this machine has no memory left for that";
  return problem.what();
}

// The value that still fits: numbers are brought into their range.
std::string fitted(const lua::Parameter& parameter, const std::string& value) {
  if (parameter.kind != lua::Parameter::Kind::number &&
      parameter.kind != lua::Parameter::Kind::integer)
    return value;
  lua::Parameter clamped = parameter;
  char* end = nullptr;
  const double number = std::strtod(value.c_str(), &end);
  if (end != value.c_str() + value.size()) return value;
  clamped.value = {std::clamp(number, parameter.least, parameter.most)};
  return lua::text_of(clamped);
}

// Throws InputError for a value that the parameter does not take.
void refuse_unfit(const recipe::Recipe& recipe, const std::string& name, const std::string& value) {
  for (const auto& known : recipe.parameters()) {
    lua::Parameter tried = known.parameter;
    if (known.name == name) lua::set_value(tried, name, value);
  }
}

}  // namespace

Workshop::Workshop(gl::Graphics& graphics, std::filesystem::path file, recipe::Options options)
    : graphics_(graphics), file_(std::move(file)), options_(std::move(options)) {
  options_.on_file = [this](const std::filesystem::path& asked) {
    files_.insert(asked);
    watcher_.watch(asked);
  };
  options_.stop = [this, stop = options_.stop] { return is_superseded() || (stop && stop()); };
  watcher_.watch(file_);
}

bool Workshop::is_superseded() {
  if (watcher_.changed()) wanted_ = superseded_ = true;
  return superseded_;
}

bool Workshop::look() {
  if (watcher_.changed()) wanted_ = true;
  return wanted_;
}

void Workshop::carry_over(recipe::Recipe& recipe) const {
  for (const auto& [name, value] : changes_.settings) {
    for (const auto& known : recipe.parameters()) {
      if (known.name != name) continue;
      try {
        recipe.set(name, fitted(known.parameter, value));
      } catch (const InputError&) {
        // The parameter is of another kind now: its own value stands, ours waits.
      }
    }
  }
  for (const auto& [object, model] : changes_.models) {
    try {
      recipe.set_model(object, model);
    } catch (const InputError&) {
      // The object is gone from the scene.
    }
  }
}

Workshop::Drawn Workshop::draw_candidate(const Moment& moment) {
  wanted_ = superseded_ = false;
  auto stage = Failure::Stage::loading;
  std::unique_ptr<recipe::Recipe> candidate;
  const auto files_before = std::exchange(files_, {file_});
  try {
    candidate = std::make_unique<recipe::Recipe>(graphics_, file_, options_);
    carry_over(*candidate);
    if (moment.camera) candidate->set_camera(*moment.camera);
    if (listener_) listener_(*candidate);
    stage = Failure::Stage::frame;
    candidate->draw(moment.time);
  } catch (const std::exception& problem) {
    files_.insert(files_before.begin(), files_before.end());
    frame_broken_ = true;
    if (superseded_) return Drawn::nothing;
    if (candidate && !candidate->is_set_up()) stage = Failure::Stage::setup;
    failure_ = failure_of(sentence_of(problem), stage);
    failure_is_its_ = false;
    return Drawn::nothing;
  }
  watcher_.keep(files_);
  coarse_.reset();
  good_ = std::move(candidate);
  failure_.reset();
  failure_is_its_ = failed_here_ = false;
  frame_broken_ = false;
  ++versions_;
  constexpr std::size_t programs = 64;  // of shaders that were edited, in case an edit is undone
  graphics_.programs.trim(programs);
  return Drawn::picture;
}

Workshop::Drawn Workshop::draw(const Moment& moment) {
  if (wanted_) {
    if (draw_candidate(moment) == Drawn::picture) return Drawn::picture;
    failed_here_ = false;
  }
  if (!good_ || failed_here_) return Drawn::nothing;
  try {
    if (std::exchange(frame_broken_, false)) {
      graphics_.begin_frame();
      graphics_.clear_buffers();
    }
    if (moment.camera) good_->set_camera(*moment.camera);
    good_->draw(moment.time);
    if (std::exchange(failure_is_its_, false)) failure_.reset();
    return Drawn::picture;
  } catch (const std::exception& problem) {
    frame_broken_ = true;
    if (superseded_) return Drawn::nothing;
    failed_here_ = true;
    // What is wrong with the version on the disk says more, and stays.
    if (!failure_ || failure_is_its_) {
      failure_ = failure_of(sentence_of(problem), Failure::Stage::frame);
      failure_is_its_ = true;
    }
    return Drawn::nothing;
  }
}

Workshop::Drawn Workshop::draw_coarse(const Moment& moment, int coarseness) {
  if (!good_ || failure_) return Drawn::nothing;
  graphics_.resize(std::max(1, graphics_.width() / coarseness),
                   std::max(1, graphics_.height() / coarseness));
  try {
    if (std::exchange(coarseness_, coarseness) != coarseness) coarse_.reset();
    if (!coarse_) coarse_ = std::make_unique<recipe::Recipe>(graphics_, file_, options_);
    for (const auto& [name, parameter] : good_->parameters())
      coarse_->set(name, lua::text_of(parameter));
    for (const auto& [object, model] : changes_.models) coarse_->set_model(object, model);
    if (moment.camera) coarse_->set_camera(*moment.camera);
    coarse_->draw(moment.time);
    return Drawn::picture;
  } catch (const std::exception&) {
    // The file changed since, or the recipe fails at this size: the sharp one will say so.
    coarse_.reset();
    return Drawn::nothing;
  }
}

void Workshop::set(const std::string& name, const std::string& value) {
  const bool made_for_it = good_ && good_->was_set_up_for(name);
  if (made_for_it) refuse_unfit(*good_, name, value);
  if (good_ && !made_for_it) good_->set(name, value);
  changes_.settings[name] = value;
  if (made_for_it) return reload();
  retry();
}

void Workshop::reset_parameters() {
  changes_ = {};
  reload();
}

void Workshop::move(const std::string& object, const glm::dmat4& model) {
  if (good_) good_->set_model(object, model);
  changes_.models[object] = model;
  retry();
}

}  // namespace shadowlab::live
