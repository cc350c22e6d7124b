// The recipe's picture, into files.
#include <fmt/format.h>

#include "live/studio.h"

namespace shadowlab::live {

// As `run` writes it: opaque, whatever the frame's alpha is.
void Studio::save_screenshot() {
  try {
    image::Image picture = graphics_.frame.read_color();
    for (std::size_t i = 3; i < picture.rgba.size(); i += 4) picture.rgba[i] = 255;
    const auto file = unused_file(bench().workshop.file().stem().string(), ".png");
    image::write_png(file, picture);
    say(fmt::format("the picture is in {}", file.string()));
  } catch (const std::exception& problem) {
    say(problem.what());
  }
}

// A film takes as long as what it shows took: of a slow recipe, and of one that is paused, a
// picture is several frames.
void Studio::film(double seconds) {
  if (!film_ || film_picture_.rgba.empty()) return;
  for (film_time_ -= seconds; film_ && film_time_ <= 0;
       film_time_ += 1.0 / Film::frames_per_second) {
    if (!film_->add(film_picture_)) toggle_film("");
  }
}

void Studio::toggle_film(const std::string& ending) {
  try {
    if (film_) {
      Film film = std::move(*film_);
      film_.reset();
      film.finish();
      say(fmt::format("{} frames are in {}", film.frames(), film.file().string()));
      return;
    }
    film_.emplace(unused_file(bench().workshop.file().stem().string(), ending), graphics_.width(),
                  graphics_.height());
    film_time_ = 0;
    film_picture_ = {};
    touch();
    say("filming; the same key ends it");
  } catch (const std::exception& problem) {
    film_.reset();
    say(problem.what());
  }
}

}  // namespace shadowlab::live
