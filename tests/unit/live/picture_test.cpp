// The picture in the middle: what is taken hold of in it, what is written over it.
#include "live/dragging.h"
#include "window_fixture.h"

namespace shadowlab::live {
namespace {

class PictureTest : public WindowTest {};

TEST_F(PictureTest, a_light_that_is_out_of_sight_is_dragged_into_it_by_its_mark_at_the_border) {
  open({stock("projected_stencil")});
  studio->step(0);
  scene::Camera camera = *studio->camera();
  camera.fovy = 20;  // too near for the light
  studio->set_camera(camera);
  const auto place = [&] {
    return seen(camera, studio->aspect(), light_handle(*studio->light(), camera));
  };
  ASSERT_GT(place().y, 2);
  frame();
  const Rectangle& area = view.picture.area();
  const glm::dvec2 there = view.picture.to_screen({place().x, place().y});
  const double mark_x = std::min(there.x, area.x + area.width - 9.6);  // .6 of a letter
  point(mark_x, area.y + 9.6);
  button(context::Press::down);
  const glm::dvec2 middle =  // in whole pixels, as a pointer is
      glm::floor(glm::dvec2(area.x + area.width / 2, area.y + area.height / 2));
  point(middle.x, middle.y);
  button(context::Press::up);
  // As it was taken hold of at its mark, it follows the pointer.
  const glm::dvec2 pointer = view.picture.from_screen(middle.x, middle.y);
  EXPECT_NEAR(place().x, pointer.x, 1e-9);
  EXPECT_NEAR(place().y, pointer.y, 1e-9);
}

TEST_F(PictureTest, numbers_are_black_where_the_picture_is_light_and_white_where_it_is_dark) {
  open({stock("projected_stencil")});
  view.picture.set_zoom(100);
  for (int i = 0; i < 3; ++i) frame();
  const image::Image color = small.frame.read_color();
  ASSERT_EQ(studio->inspector().buffers().color, color);
  int light = 0, dark = 0;
  for (std::size_t i = 0; i < color.rgba.size() / 4; ++i) {
    const int least = std::min({color.rgba[4 * i], color.rgba[4 * i + 1], color.rgba[4 * i + 2]});
    const int most = std::max({color.rgba[4 * i], color.rgba[4 * i + 1], color.rgba[4 * i + 2]});
    // Whatever the weights of the channels are.
    light += least > 127 ? 1 : 0;
    dark += most < 128 ? 1 : 0;
    if (least <= 127 && most >= 128) continue;
    EXPECT_EQ(studio->is_light_at(i), least > 127) << i;
  }
  EXPECT_GT(light, 100);
  EXPECT_GT(dark, 100);
  studio->look_at({LookedAt::Buffer::stencil, 0});
  frame();
  EXPECT_FALSE(studio->is_light_at(0)) << "a stencil of 0 is black";
  studio->look_at({LookedAt::Buffer::depth, 0});
  frame();
  EXPECT_TRUE(studio->is_light_at(0)) << "what is far away is white";
}

}  // namespace
}  // namespace shadowlab::live
