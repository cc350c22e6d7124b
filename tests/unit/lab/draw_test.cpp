// What is drawn for a mark, and what a recipe's faults leave of it.
#include <gmock/gmock.h>

#include "lab_fixture.h"

namespace shadowlab::lab {
namespace {

constexpr std::array<std::uint8_t, 4> red{255, 0, 0, 255}, blue{0, 0, 255, 255};

TEST_F(LabTest, each_shot_has_its_own_settings_and_its_own_globals) {
  const TextFile file("seen = (rawget(_G, 'seen') or 0) + 1\n" +
                      recipe_text("gl.ClearColor(r.params.red, 0, seen - 1, 1)\n"
                                  "gl.Clear(gl.COLOR_BUFFER_BIT)",
                                  "params = { red = param.number(0, 0, 1) }"));
  Job job = one_shot(file.path());
  job.shots.emplace_back().settings.emplace_back("red", "1");
  const auto drawings = draw_all(job);
  ASSERT_EQ(drawings.size(), 2u);
  ASSERT_FALSE(drawings[0].error) << *drawings[0].error;
  EXPECT_EQ(drawings[0].frame.color.at(3, 3), (std::array<std::uint8_t, 4>{0, 0, 0, 255}));
  EXPECT_EQ(drawings[1].frame.color.at(3, 3), red);
}

TEST_F(LabTest, each_pass_leaves_its_buffers_and_calls) {
  const TextFile file(
      recipe_text("pass('one', function() gl.ClearColor(1, 0, 0, 1) gl.Clear(gl.COLOR_BUFFER_BIT) "
                  "end) pass('two', function() gl.ClearStencil(7) gl.ClearColor(0, 0, 1, 1) "
                  "gl.Clear(gl.COLOR_BUFFER_BIT | gl.STENCIL_BUFFER_BIT) end)"));
  const auto drawing = draw_one(file.path());
  ASSERT_EQ(drawing.passes.size(), 2u);
  EXPECT_EQ(drawing.passes[0].pass, "one");
  EXPECT_EQ(drawing.passes[0].color.at(0, 0), red);
  EXPECT_EQ(drawing.passes[0].stencil[0], 0);
  EXPECT_EQ(drawing.passes[1].color.at(0, 0), blue);
  EXPECT_EQ(drawing.passes[1].stencil[0], 7);
  ASSERT_EQ(drawing.calls.size(), 5u);
  EXPECT_EQ(drawing.calls[2].function, "glClearStencil");
  EXPECT_THAT(drawing.calls[2].arguments, testing::ElementsAre("7"));
  EXPECT_EQ(drawing.calls[2].pass, 1);
}

TEST_F(LabTest, nothing_is_kept_that_is_not_asked_for) {
  const TextFile file(recipe_text("pass('one', function() gl.Clear(gl.COLOR_BUFFER_BIT) end)"));
  Job job = one_shot(file.path());
  job.frame = {.color = true};
  const Drawing picture = draw_all(job).at(0);
  EXPECT_EQ(picture.frame.color.width, frame_size);
  EXPECT_TRUE(picture.frame.depth.values.empty());
  EXPECT_TRUE(picture.frame.stencil.empty());
  EXPECT_TRUE(picture.passes.empty());
  EXPECT_TRUE(picture.calls.empty());
  job.passes = {.stencil = true};
  const Drawing with_stencil = draw_all(job).at(0);
  ASSERT_EQ(with_stencil.passes.size(), 1u);
  EXPECT_FALSE(with_stencil.passes[0].stencil.empty());
  EXPECT_TRUE(with_stencil.passes[0].color.rgba.empty());
}

TEST_F(LabTest, a_recipe_that_fails_keeps_what_it_drew_before) {
  const TextFile file(recipe_text(
      "pass('one', function() gl.ClearColor(1, 0, 0, 1) gl.Clear(gl.COLOR_BUFFER_BIT) end)\n"
      "pass('two', function() gl.Enable(nil) end)"));
  const auto drawing = draw_one(file.path());
  ASSERT_TRUE(drawing.error);
  EXPECT_THAT(*drawing.error, testing::HasSubstr("in pass \"two\""));
  EXPECT_EQ(drawing.passes.size(), 1u);
  EXPECT_EQ(drawing.frame.color.at(1, 1), red);
}

TEST_F(LabTest, a_file_that_is_no_recipe_is_an_error_of_the_drawing) {
  const TextFile file("return 7");
  EXPECT_THAT(*draw_one(file.path()).error, testing::HasSubstr("this file returns a number"));
}

TEST_F(LabTest, a_camera_takes_the_place_of_the_scenes) {
  const TextFile file(
      recipe_text("local eye = r.scene.camera.eye gl.ClearColor(eye.x / 10, 0, 0, 1) "
                  "gl.Clear(gl.COLOR_BUFFER_BIT)",
                  "scene = 'table'"));
  scene::Camera camera;
  camera.eye = {10, 0, 0};
  Job job = one_shot(file.path());
  job.shots[0].camera = camera;
  const auto drawings = draw_all(job);
  ASSERT_FALSE(drawings[0].error) << *drawings[0].error;
  EXPECT_EQ(drawings[0].frame.color.at(0, 0), red);
}

TEST_F(LabTest, a_change_holds_for_the_draws_from_its_place_on) {
  const TextFile file(
      recipe_text("local s = shader.compile { vertex = [[#version 330 core\nlayout(location = 0) "
                  "in vec3 position; void main() { gl_Position "
                  "= vec4(position, 1); }]], fragment = [[#version 330 core\nout vec4 color; void "
                  "main() { color = "
                  "vec4(1); }]] } local quad = mesh.quad() gl.ColorMask(false, false, true, true) "
                  "quad:draw(s) gl.ColorMask(false, true, false, true) quad:draw(s)"));
  Job job = one_shot(file.path());
  job.calls = true;
  const Drawing before = draw_all(job).at(0);
  ASSERT_FALSE(before.error) << *before.error;
  EXPECT_EQ(before.frame.color.at(16, 16), (std::array<std::uint8_t, 4>{0, 255, 255, 255}));
  std::size_t first = 0;
  while (!before.calls[first].function.starts_with("glDraw")) ++first;
  job.shots[0].changes = {{first, "glColorMask", {"GL_TRUE", "GL_FALSE", "GL_FALSE", "GL_TRUE"}}};
  const Drawing changed = draw_all(job).at(0);
  EXPECT_EQ(changed.frame.color.at(16, 16), (std::array<std::uint8_t, 4>{255, 255, 0, 255}));
  EXPECT_EQ(changed.calls.size(), before.calls.size()) << "changes leave no trace";
}

TEST_F(LabTest, passes_without_end_are_not_all_kept) {
  const TextFile file(recipe_text("for i = 1, 200 do pass('p', function() end) end"));
  const auto drawing = draw_one(file.path());
  EXPECT_FALSE(drawing.error);
  EXPECT_EQ(drawing.passes.size(), most_passes);
}

}  // namespace
}  // namespace shadowlab::lab
