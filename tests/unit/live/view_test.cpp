// Where pictures are on the screen, and what is drawn over them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "live/overlay.h"
#include "live/picture_view.h"
#include "scene/scene.h"

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

TEST(Overlay, shapes_are_those_of_the_scene_after_each_change_of_it) {
  scene::Scene scene;
  const auto box = std::make_shared<const scene::Mesh>(scene::box({1, 1, 1}));
  scene.objects.push_back({"box", box, glm::dmat4(1), {}, scene::Role::both});
  scene::Camera camera;
  glm::dvec4 light(1, 5, 2, 1);
  OverlayShapes shown;
  const auto same = [&](Overlay overlay) {
    const auto& ours = shown.of(overlay, scene, camera, 1.5, light);
    const auto fresh = shapes(overlay, scene, camera, 1.5, light);
    return std::ranges::equal(ours, fresh, {}, &Shape::points, &Shape::points);
  };
  for (const Overlay overlay :
       {Overlay::silhouettes, Overlay::volumes, Overlay::frustum, Overlay::cascades}) {
    EXPECT_TRUE(same(overlay));
    EXPECT_TRUE(same(overlay)) << "unchanged";
    light.x += 3;
    EXPECT_TRUE(same(overlay)) << "another light";
    scene.objects[0].model[3].x += 1;
    EXPECT_TRUE(same(overlay)) << "moved";
    camera.eye.x += 1;
    EXPECT_TRUE(same(overlay)) << "another camera";
    scene.objects.push_back({"other", box, glm::dmat4(2), {}, scene::Role::both});
    EXPECT_TRUE(same(overlay)) << "another object";
  }
}

}  // namespace
}  // namespace shadowlab::live
