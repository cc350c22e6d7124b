// A live session without its window: looking, stepping, dragging, panels.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/error.h"
#include "core/version.h"
#include "live/commands.h"
#include "live/panels.h"
#include "workshop_fixture.h"

namespace shadowlab::live {
namespace {

constexpr int size = 48;
constexpr double frame = 1.0 / 60;

struct Seen3 {
  image::Image color;
  std::vector<float> depth;
  std::vector<std::uint8_t> stencil;
  bool operator==(const Seen3&) const = default;
};

Seen3 buffers(const gl::Graphics& graphics) {
  return {graphics.frame.read_color(), graphics.frame.read_depth().values,
          graphics.frame.read_stencil()};
}

// A screen that is looked at, without a window.
class StudioTest : public WorkshopTest {
 protected:
  StudioTest() : small(context::create(context::Backend::osmesa, {640, 400}), size, size) {}

  std::unique_ptr<Studio> studio(std::vector<fs::path> recipes) {
    return std::make_unique<Studio>(small, StudioOptions{std::move(recipes), {}, {}});
  }
  static fs::path stock(const std::string& name) { return home() / "scripts" / (name + ".lua"); }

  gl::Graphics small;
};

// Every pass is chosen in turn, with every buffer, its pixel, its calls and the panels.
TEST_F(StudioTest, looking_changes_no_pixel) {
  for (const char* const name : {"projected_stencil", "volumes_zfail", "shadow_map_fbo", "fbo_blit",
                                 "banding", "stencil_basics"}) {
    Seen3 alone;
    {
      recipe::Recipe recipe(small, stock(name));
      recipe.draw();
      recipe.draw();
      alone = buffers(small);
    }
    const auto studio = this->studio({stock(name)});
    studio->clock().toggle_pause();
    Interface interface(small);
    gl::Screen screen(small);
    View view;
    studio->set_tracing(Studio::Tracing::on);
    studio->set_pixel(glm::ivec2(20, 30));
    studio->step(0);
    const std::size_t passes = studio->inspector().passes().size();
    ASSERT_GT(passes, 0u) << name;
    for (std::size_t i = 0; i < std::min<std::size_t>(passes, 5); ++i) {
      studio->step_pass(1);
      studio->look_at_next();
      interface.begin({640, 400}, frame);
      draw_window(*studio, view, interface);
      screen.begin(640, 400, {0, 0, 0});
      interface.end(screen);
      studio->touch();
      studio->step(0);
      EXPECT_EQ(buffers(small), alone) << name << ", pass " << i;
    }
  }
}

TEST_F(StudioTest, the_buffers_of_a_pass_are_those_at_its_end) {
  const auto studio = this->studio({stock("projected_stencil")});
  std::vector<image::Image> colors;
  {
    recipe::Recipe recipe(small, stock("projected_stencil"));
    recipe.on_pass_end([&](std::size_t) { colors.push_back(small.frame.read_color()); });
    recipe.draw();
  }
  studio->step(0);
  ASSERT_EQ(studio->inspector().passes().size(), colors.size());
  for (std::size_t i = 0; i < colors.size(); ++i) {
    studio->step_pass(1);
    studio->step(0);
    ASSERT_EQ(studio->inspector().kept_pass(), i);
    EXPECT_EQ(studio->inspector().buffers().color, colors[i]);
  }
  studio->step_pass(1);
  EXPECT_FALSE(studio->chosen_pass()) << "after the last comes the whole frame";
}

TEST_F(StudioTest, a_pixels_history_is_its_value_after_each_pass) {
  const auto studio = this->studio({stock("projected_stencil")});
  studio->set_pixel(glm::ivec2(24, 26));
  studio->step(0);
  const auto& passes = studio->inspector().passes();
  ASSERT_FALSE(passes.empty());
  ASSERT_TRUE(passes.back().pixel);
  EXPECT_EQ(passes.back().pixel->rgba, small.frame.read_color().at(24, 26));
  EXPECT_EQ(passes.back().pixel->stencil, small.frame.read_stencil()[26 * size + 24]);
  EXPECT_EQ(passes.back().pixel->depth, small.frame.read_depth().values[26 * size + 24]);
}

TEST_F(StudioTest, the_state_of_a_pass_is_the_c_that_makes_it) {
  const auto studio = this->studio({stock("projected_stencil")});
  studio->step(0);
  studio->step_pass(2);
  studio->step(0);
  const auto& pass = studio->inspector().passes()[1];
  ASSERT_TRUE(pass.state);
  const auto lines = gl::as_c(*pass.state, small.calls().main_frame);
  for (const char* const line :
       {"glDisable(GL_DEPTH_TEST);", "glEnable(GL_STENCIL_TEST);",
        "glStencilFunc(GL_EQUAL, 1, 0xFF);", "glStencilOp(GL_KEEP, GL_KEEP, GL_ZERO);",
        "glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);",
        "glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);"}) {
    EXPECT_NE(std::ranges::find(lines, line), lines.end()) << line;
  }
}

TEST_F(StudioTest, a_map_that_a_pass_drew_to_can_be_looked_at) {
  const auto studio = this->studio({stock("shadow_map_fbo")});
  studio->step(0);
  studio->step_pass(1);
  studio->step(0);
  studio->step(0);
  const auto& attachments = studio->inspector().buffers().attachments;
  ASSERT_EQ(attachments.size(), 1u);
  EXPECT_TRUE(attachments[0].values.empty()) << "nobody looks at them";
  studio->look_at({LookedAt::Buffer::attachment, 0});
  studio->step(0);
  ASSERT_EQ(attachments.size(), 1u);
  EXPECT_EQ(attachments[0].name, "GL_DEPTH_ATTACHMENT");
  EXPECT_EQ(attachments[0].width, 1024);
  EXPECT_LT(*std::ranges::min_element(attachments[0].values), 1.0f);
  EXPECT_EQ(*std::ranges::max_element(attachments[0].values), 1.0f);
}

TEST_F(StudioTest, the_chosen_pass_and_the_camera_survive_a_reload) {
  const auto text = [](const char* first) {
    return std::string("local recipe = { scene = \"table\" }\nfunction recipe.draw(r)\n") + first +
           "pass(\"a\", function() end) pass(\"b\", function() end)\nend\nreturn recipe\n";
  };
  write("a.lua", text(""));
  const auto studio = this->studio({folder / "a.lua"});
  studio->step(0);
  studio->step_pass(2);
  studio->set_camera(orbited(*studio->camera(), 30, 10));
  const scene::Camera camera = *studio->camera();
  write("a.lua", text("pass(\"new\", function() end)\n"));
  while (studio->bench().workshop.versions() < 2) studio->step(0);
  EXPECT_EQ(studio->chosen_pass()->name, "b");
  EXPECT_EQ(studio->inspector().kept_pass(), 2u);
  EXPECT_EQ(studio->bench().workshop.recipe()->scene()->camera.eye, camera.eye);
}

// The frames in which a new version warms up come first.
TEST_F(StudioTest, a_recipe_that_does_not_ask_for_the_time_stands_still) {
  const auto text = [](const char* read) {
    return std::string("local recipe = { params = { a = param.number(0, 0, 1) } }\n") +
           "function recipe.draw(r) print(" + read + ") end\nreturn recipe\n";
  };
  write("still.lua", text("r.params.a"));
  write("moving.lua", text("r.time"));
  for (const bool moving : {false, true}) {
    int frames = 0;
    StudioOptions wanted{{folder / (moving ? "moving.lua" : "still.lua")}, {}, {}};
    wanted.recipe.print = [&frames](std::string_view) { ++frames; };
    Studio session(small, wanted);
    for (int i = 0; i < 10; ++i) session.step(frame);
    const int warm = frames;
    for (int i = 0; i < 10; ++i) session.step(frame);
    EXPECT_EQ(frames - warm, moving ? 10 : 0);
    session.set("a", "0.5");
    session.step(frame);
    EXPECT_EQ(frames - warm, moving ? 11 : 1);
  }
}

TEST_F(StudioTest, recipes_of_one_scene_begin_under_the_first_ones_light) {
  const auto studio = this->studio({stock("projected_stencil"), stock("volumes_zfail")});
  studio->step(0);
  const glm::dvec4 first = *studio->light();
  studio->set_focus(1);
  EXPECT_EQ(*studio->light(), first);
}

TEST_F(StudioTest, the_state_of_a_pass_is_there_when_a_version_has_it_elsewhere) {
  const auto text = [](const char* first) {
    return std::string("local recipe = {}\nfunction recipe.draw(r)\n") + first +
           "pass(\"b\", function() gl.Enable(gl.BLEND) end)\nend\nreturn recipe\n";
  };
  write("a.lua", text(""));
  const auto studio = this->studio({folder / "a.lua"});
  for (int i = 0; i < 5; ++i) studio->step(0);
  studio->step_pass(1);
  write("a.lua", text("pass(\"x\", function() end) pass(\"y\", function() end)\n"));
  while (studio->bench().workshop.versions() < 2) studio->step(0);
  for (int i = 0; i < 5; ++i) studio->step(0);
  ASSERT_EQ(studio->inspector().passes().size(), 3u);
  EXPECT_TRUE(studio->inspector().passes()[2].state);
}

TEST_F(StudioTest, another_session_takes_over_what_was_done_in_the_first) {
  const auto first = this->studio({stock("projected_stencil")});
  first->step(0);
  first->set("darkness", "0.75");
  first->set_camera(orbited(*first->camera(), 30, 10));
  first->step_pass(2);
  Studio second(small, {{stock("projected_stencil")}, {}, {}}, first->kept());
  second.step(0);
  EXPECT_EQ(second.camera()->eye, first->camera()->eye);
  EXPECT_EQ(second.chosen_pass(), first->chosen_pass());
  const auto& parameters = second.bench().workshop.recipe()->parameters();
  EXPECT_EQ(lua::text_of(parameters[0].parameter), "0.75");
}

TEST_F(StudioTest, the_light_of_one_recipe_is_the_light_of_all) {
  const auto studio = this->studio({stock("projected_plain"), stock("projected_stencil")});
  studio->step(0);
  studio->set_light({1, 3, 2, 1});
  studio->set_focus(1);
  EXPECT_EQ(*studio->light(), glm::dvec4(1, 3, 2, 1));
}

TEST_F(StudioTest, what_is_dragged_follows_the_hand) {
  const auto studio = this->studio({stock("projected_stencil")});
  studio->step(0);
  const auto place = [&] {
    const Seen at = seen(*studio->camera(), studio->aspect(),
                         light_handle(*studio->light(), *studio->camera()));
    return glm::dvec2(at.x, at.y);
  };
  const glm::dvec2 from = place(), to = from + glm::dvec2(-0.3, 0.1);
  ASSERT_EQ(studio->grip_at(from, 0.05), Studio::Grip::light);
  studio->grab(from, Studio::Grip::light);
  studio->drag(to);
  EXPECT_LT(glm::length(place() - to), 1e-9);  // through the light's text and back
}

TEST_F(StudioTest, keys_do_what_the_help_says) {
  const auto studio = this->studio({stock("projected_stencil")});
  studio->step(0);
  View view;
  const auto press = [&](context::Key key, context::Modifiers held = {}, char character = 0) {
    return run_command({key, character, context::Press::down, held}, *studio, view);
  };
  EXPECT_TRUE(press(context::Key::down));
  EXPECT_TRUE(studio->chosen_pass());
  EXPECT_TRUE(press(context::Key::f1));
  EXPECT_TRUE(view.help);
  EXPECT_TRUE(press(context::Key::escape));
  EXPECT_TRUE(view.open) << "the help is closed first";
  EXPECT_TRUE(press(context::Key::escape));
  EXPECT_FALSE(view.open);
  EXPECT_FALSE(press(context::Key::character, {}, 'z'));
  EXPECT_TRUE(studio->press("s"));
  EXPECT_FALSE(studio->press("z"));
}

TEST_F(StudioTest, the_numbers_of_the_whole_frame_are_there_when_it_is_enlarged) {
  const auto studio = this->studio({stock("projected_stencil")});
  Interface interface(small);
  gl::Screen screen(small);
  View view;
  for (const double zoom : {1.0, 100.0}) {
    view.picture.set_zoom(zoom);
    interface.begin({640, 400}, frame);
    draw_window(*studio, view, interface);
    screen.begin(640, 400, {0, 0, 0});
    interface.end(screen);
    studio->step(0);
    EXPECT_EQ(studio->inspector().buffers().color.rgba.empty(), zoom == 1);
  }
  EXPECT_EQ(studio->inspector().buffers().color, small.frame.read_color());
}

TEST_F(StudioTest, a_window_of_one_pixel_is_drawn) {
  const auto studio = this->studio({stock("projected_stencil")});
  studio->step(0);
  Interface interface(small);
  gl::Screen screen(small);
  View view;
  view.help = true;
  for (const Style style : {Style::desk, Style::projector}) {
    interface.set_style(style, 1);
    interface.begin({1, 1}, frame);
    draw_window(*studio, view, interface);
    screen.begin(1, 1, {0, 0, 0});
    interface.end(screen);
  }
}

TEST_F(StudioTest, a_slow_recipe_is_coarse_while_a_hand_moves_and_sharp_again_at_rest) {
  const auto studio = this->studio({stock("projected_stencil")});
  studio->clock().toggle_pause();
  studio->step(frame);
  const scene::Camera camera = orbited(*studio->camera(), 20, 5);
  for (const auto& [milliseconds, width] : {std::pair{1000, size / 4}, {100, size / 2}}) {
    studio->bench().frame_ms = milliseconds;
    studio->set_camera(camera);
    studio->step(frame);
    EXPECT_EQ(studio->bench().picture.width(), width);
    EXPECT_EQ(small.width(), size);
  }
  for (int i = 0; i < 20; ++i) studio->step(frame);
  EXPECT_EQ(studio->bench().picture.width(), size);
  const Seen3 shown = buffers(small);
  recipe::Recipe alone(small, stock("projected_stencil"));
  alone.set_camera(camera);
  alone.draw();
  EXPECT_EQ(shown, buffers(small));

  studio->set_detail(Studio::Detail::full);
  studio->bench().frame_ms = 1000;
  studio->set_camera(camera);
  studio->step(frame);
  EXPECT_EQ(studio->bench().picture.width(), size) << "the switch is off";
}

TEST_F(StudioTest, the_time_of_a_frame_is_not_that_of_a_version_that_failed) {
  write("a.lua", filling(10));
  const auto studio = this->studio({folder / "a.lua"});
  for (int i = 0; i < 4; ++i) studio->step(frame);
  studio->bench().frame_ms = -1;
  write("a.lua", "error \"too late\"");
  studio->step(frame);
  ASSERT_TRUE(studio->bench().workshop.failure());
  EXPECT_EQ(studio->bench().frame_ms, -1);
  studio->touch();
  studio->step(frame);
  EXPECT_GT(studio->bench().frame_ms, 0);
}

TEST_F(StudioTest, the_truth_is_traced_when_the_hand_rests) {
  const auto studio = this->studio({stock("volumes_zfail")});
  studio->step(frame);
  studio->set_truth_mode(TruthMode::error);
  studio->step(frame);
  EXPECT_FALSE(studio->truth().busy());
  for (int i = 0; i < 20; ++i) studio->step(frame);
  while (studio->truth().busy()) studio->step(frame);
  ASSERT_TRUE(studio->truth().shows()) << studio->truth().sentence();
  // Volumes are exact but for what an edge of the lattice leaves to rounding.
  EXPECT_LT(studio->truth().wrong(), static_cast<std::size_t>(size));
  EXPECT_NE(studio->truth().sentence().find("0 beyond an edge"), std::string::npos)
      << studio->truth().sentence();
}

TEST_F(StudioTest, a_film_goes_through_ffmpeg_and_without_it_a_sentence_says_so) {
  write("ffmpeg", "#!/bin/sh\nfor last; do :; done\nexec /bin/cat >\"${last#file:}\"\n");
  fs::permissions(folder / "ffmpeg", fs::perms::owner_all);
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", (folder.string() + ":" + path).c_str(), 1);
  const image::Image picture(4, 2, {1, 2, 3, 255});
  {
    Film film(folder / "a film.mp4", 4, 2);
    EXPECT_TRUE(film.add(picture));
    EXPECT_TRUE(film.add(picture));
    film.finish();
  }
  EXPECT_EQ(fs::file_size(folder / "a film.mp4"), 2u * 4 * 4 * 2);
  ::setenv("PATH", "/nowhere", 1);
  EXPECT_THROW(Film(folder / "b.mp4", 4, 2), MachineError);
  ::setenv("PATH", path.c_str(), 1);
}

TEST(Stepped, stays_in_the_range_and_goes_round_in_a_choice) {
  using Kind = lua::Parameter::Kind;
  EXPECT_EQ(stepped({Kind::number, {0.99}, 0, 1, {}}, 1), "1");
  EXPECT_EQ(stepped({Kind::integer, {5}, 1, 64, {}}, -1), "4");
  EXPECT_EQ(stepped({Kind::choice, {1}, 0, 0, {"a", "b"}}, 1), "a");
  EXPECT_EQ(stepped({Kind::toggle, {1}, 0, 1, {}}, 1), "false");
}

}  // namespace
}  // namespace shadowlab::live
