#include "live/picture_view.h"

#include <algorithm>
#include <cmath>

namespace shadowlab::live {
namespace {

constexpr double least_zoom = 1.0 / 16, most_zoom = 128;

}  // namespace

void PictureView::set_zoom(double zoom) {
  zoom_ = std::clamp(zoom, least_zoom, most_zoom);
  center_ = glm::dvec2(0.5);
}

void PictureView::zoom_at(double factor, double x, double y) {
  const double before = zoom();
  const double after = std::clamp(before * factor, least_zoom, most_zoom);
  const glm::dvec2 at =
      glm::dvec2(x - placed_.x, y - placed_.y) / glm::dvec2(placed_.width, placed_.height);
  const glm::dvec2 middle(area_.x + area_.width / 2, area_.y + area_.height / 2);
  zoom_ = after;
  center_ = at + (middle - glm::dvec2(x, y)) / (picture_ * after);
  place(area_, static_cast<int>(picture_.x), static_cast<int>(picture_.y));
}

void PictureView::pan(double x, double y) {
  if (!zoom_) zoom_ = zoom();
  center_ -= glm::dvec2(x, y) / (picture_ * *zoom_);
}

void PictureView::pan_to(glm::ivec2 pixel) {
  const glm::dvec2 low = corner_of(pixel.x, pixel.y), high = corner_of(pixel.x + 1, pixel.y + 1);
  const auto by = [](double from, double to, double least, double most) {
    return from < least ? least - from : std::min(0.0, most - to);
  };
  const double x = by(low.x, high.x, area_.x, area_.x + area_.width);
  const double y = by(low.y, high.y, area_.y, area_.y + area_.height);
  if (x != 0 || y != 0) pan(x, y);
}

void PictureView::place(Rectangle area, int width, int height) {
  area_ = area;
  picture_ = {std::max(width, 1), std::max(height, 1)};
  const double as_it_fits = std::clamp(std::min(area.width / picture_.x, area.height / picture_.y),
                                       least_zoom, most_zoom);
  const double zoom = zoom_.value_or(as_it_fits);
  if (!zoom_) center_ = glm::dvec2(0.5);
  placed_.width = picture_.x * zoom;
  placed_.height = picture_.y * zoom;
  placed_.x = std::round(area.x + area.width / 2 - center_.x * placed_.width);
  placed_.y = std::round(area.y + area.height / 2 - center_.y * placed_.height);
}

std::optional<glm::ivec2> PictureView::pixel_at(double x, double y) const {
  if (!area_.holds(x, y) || !placed_.holds(x, y)) return {};
  const glm::dvec2 at = glm::dvec2(x - placed_.x, y - placed_.y) / zoom();
  return glm::ivec2(std::min(at.x, picture_.x - 1), std::min(at.y, picture_.y - 1));
}

glm::dvec2 PictureView::corner_of(double pixel_x, double pixel_y) const {
  return {placed_.x + pixel_x * zoom(), placed_.y + pixel_y * zoom()};
}

glm::dvec2 PictureView::to_screen(glm::dvec2 place) const {
  return {placed_.x + (place.x + 1) / 2 * placed_.width,
          placed_.y + (1 - place.y) / 2 * placed_.height};
}

glm::dvec2 PictureView::from_screen(double x, double y) const {
  return {(x - placed_.x) / placed_.width * 2 - 1, 1 - (y - placed_.y) / placed_.height * 2};
}

}  // namespace shadowlab::live
