// Where pictures are on the screen, and what is drawn over them.
#include <gtest/gtest.h>

#include <cmath>

#include "live/overlay.h"
#include "live/picture_view.h"

namespace shadowlab::live {
namespace {

TEST(PictureView, puts_pixels_on_pixels_at_whole_zooms) {
  PictureView view;
  view.set_zoom(2);
  view.place({100, 0, 300, 200}, 64, 48);
  EXPECT_EQ(view.placed().x, std::round(view.placed().x));
  EXPECT_EQ(view.placed().width, 128);
  for (const glm::ivec2 pixel : {glm::ivec2(0, 0), glm::ivec2(63, 47), glm::ivec2(10, 20)}) {
    const glm::dvec2 corner = view.corner_of(pixel.x, pixel.y);
    EXPECT_EQ(view.pixel_at(corner.x, corner.y), pixel);
    EXPECT_EQ(view.pixel_at(corner.x + 1.5, corner.y + 1.5), pixel);
  }
  EXPECT_FALSE(view.pixel_at(view.placed().x - 1, view.placed().y));
}

TEST(PictureView, zooms_about_the_place_under_the_pointer) {
  PictureView view;
  view.place({0, 0, 400, 400}, 100, 100);
  const auto before = view.from_screen(100, 300);
  view.zoom_at(4, 100, 300);
  const auto after = view.from_screen(100, 300);
  // The corner is put on a whole pixel: half a pixel of a picture of 1600.
  EXPECT_LE(glm::length(after - before), 2 * 0.71 / 800);
}

TEST(Overlay, what_is_behind_the_eye_is_cut_off) {
  scene::Camera camera;
  camera.eye = {0, 0, 4};
  camera.target = {0, 0, 0};
  camera.near = 1;
  const Shape through{Shape::Kind::line, {{0, 0, 0}, {0, 1, 8}}, 0};
  const auto line = projected(through, camera, 1);
  ASSERT_EQ(line.size(), 2u);
  EXPECT_TRUE(std::isfinite(line[1].y));
  EXPECT_GT(line[1].y, 0);
  EXPECT_TRUE(projected({Shape::Kind::line, {{0, 0, 5}, {0, 1, 8}}, 0}, camera, 1).empty());
}

}  // namespace
}  // namespace shadowlab::live
