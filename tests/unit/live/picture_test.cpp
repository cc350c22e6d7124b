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

TEST_F(PictureTest, what_a_mouse_moves_keys_move_too) {
  using context::Key;
  constexpr context::Modifiers control_shift{true, true, false}, control{false, true, false},
      shift{true, false, false};
  open({stock("volumes_zfail")});
  frame();
  const auto place = [&] {
    for (const auto& object : studio->bench().workshop.recipe()->scene()->objects)
      if (object.casts()) return glm::dvec3(object.model[3]);
    return glm::dvec3(0);
  };
  const glm::dvec3 before = place();
  press(Key::up, control_shift);
  press(Key::right, control_shift);
  const glm::dvec3 after = place();
  EXPECT_NE(after.x, before.x);
  EXPECT_NE(after.z, before.z);
  EXPECT_EQ(after.y, before.y) << "along the floor";
  press(Key::down, control_shift);
  press(Key::left, control_shift);
  EXPECT_NEAR(glm::length(place() - before), 0, 1e-12);
  EXPECT_EQ(studio->bench().workshop.changes().models.size(), 1u);

  const double slider = view.slider;
  press(Key::end, control);
  EXPECT_GT(view.slider, slider);

  press(Key::down);
  for (int i = 0; i < 3; ++i) frame();
  const auto details = [&] {  // the lowest rows of the right panel
    frame();
    const image::Image picture = screen.read();
    std::vector<std::array<std::uint8_t, 4>> pixels;
    for (int y = 300; y < 350; ++y)
      for (int x = 450; x < width; ++x) pixels.push_back(picture.at(x, y));
    return pixels;
  };
  const auto above = details();
  press(Key::page_down, shift);
  frame();
  EXPECT_NE(details(), above) << "the state is longer than its place";
  press(Key::page_up, shift);
  frame();
  EXPECT_EQ(details(), above);
}

TEST_F(PictureTest, the_truth_is_beside_the_picture_at_its_size) {
  open({stock("shadow_map_fbo")});
  frame();
  studio->set_truth_mode(TruthMode::beside);
  for (int i = 0; i < 10'000 && !studio->truth().shows(); ++i) studio->step(1);
  ASSERT_TRUE(studio->truth().shows());
  frame();
  const Rectangle& at = view.picture.placed();
  const image::Image shown = screen.read();
  const auto pixel = [&](double x, double y) {
    return shown.at(static_cast<int>(x), static_cast<int>(y));
  };
  const std::array<std::uint8_t, 4> white{255, 255, 255, 255}, black{0, 0, 0, 255};
  EXPECT_NE(pixel(at.x + 2, at.y + 2), white) << "the scene's ground";
  EXPECT_EQ(pixel(at.x + view.picture.area().width + 2, at.y + 2), white) << "the light reaches it";
  int dark = 0;
  for (int y = 0; y < static_cast<int>(at.height); ++y)
    for (int x = 0; x < static_cast<int>(at.width); ++x)
      dark += pixel(at.x + view.picture.area().width + x, at.y + y) == black ? 1 : 0;
  EXPECT_GT(dark, 50) << "the shadow";
}

TEST_F(PictureTest, keys_lead_to_a_pixel_and_enlarge_it) {
  using context::Key;
  open({stock("projected_stencil")});
  frame();
  constexpr context::Modifiers alt{false, false, true}, control{false, true, false};
  for (int i = 0; i < 60; ++i) press(Key::left, alt);
  for (int i = 0; i < 8; ++i) {
    run_command({Key::character, '+', context::Press::down, control}, *studio, view);
    frame();
  }
  ASSERT_EQ(studio->pixel(), glm::ivec2(0, 24));
  for (int i = 0; i < 20; ++i) {
    press(Key::right, alt);
    frame();
  }
  const glm::dvec2 corner = view.picture.corner_of(20, 24);
  EXPECT_TRUE(view.picture.area().holds(corner.x, corner.y)) << "the picture follows the pixel";
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
