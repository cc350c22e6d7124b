// Where a picture is on the screen, and which of its pixels is where.
#pragma once

#include <glm/glm.hpp>
#include <optional>

namespace shadowlab::live {

struct Rectangle {
  double x = 0, y = 0, width = 0, height = 0;  ///< pixels of the screen, from its top left
  bool holds(double at_x, double at_y) const {
    return at_x >= x && at_y >= y && at_x < x + width && at_y < y + height;
  }
};

class PictureView {
 public:
  /// The whole picture as large as it fits.
  void fit() { zoom_.reset(); }
  /// So many pixels of the screen for one of the picture, around the middle.
  void set_zoom(double zoom);
  /// Nearer or farther, with what is at that place of the screen staying there.
  void zoom_at(double factor, double x, double y);
  void pan(double x, double y);
  /// So far that this pixel, from the left and the top, is in the area.
  void pan_to(glm::ivec2 pixel);

  /// Puts a picture of that size into `area`. Whole zooms put pixels on pixels.
  void place(Rectangle area, int width, int height);

  const Rectangle& area() const { return area_; }
  const Rectangle& placed() const { return placed_; }  ///< may reach beyond the area
  double zoom() const { return placed_.width / picture_.x; }
  bool fits() const { return !zoom_; }
  /// The pixel of the picture there, from the left and the top.
  std::optional<glm::ivec2> pixel_at(double x, double y) const;
  /// Where the upper left corner of a pixel is.
  glm::dvec2 corner_of(double pixel_x, double pixel_y) const;
  /// From the picture's -1 to 1, y up, to the screen, and back.
  glm::dvec2 to_screen(glm::dvec2 place) const;
  glm::dvec2 from_screen(double x, double y) const;

 private:
  std::optional<double> zoom_;  ///< nothing: as it fits
  glm::dvec2 center_{0.5};      ///< what of the picture is at the area's middle, 0 to 1
  glm::dvec2 picture_{1};
  Rectangle area_, placed_;
};

}  // namespace shadowlab::live
