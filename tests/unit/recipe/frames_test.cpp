// Frames and recipes leave each other alone; looking at one changes nothing.
#include "recipe_fixture.h"

namespace shadowlab::recipe {
namespace {

using RecipeFrames = RecipeTest;

constexpr const char* wild = R"lua(
local recipe = {}
function recipe.draw(r)
  gl.ClearColor(1, 0, 1, 1)
  gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT)
  gl.ClearDepth(0.25)
  gl.ClearStencil(7)
  gl.ColorMask(false, true, false, true)
  gl.DepthMask(false)
  gl.StencilMask(0)
  gl.Enable(gl.SCISSOR_TEST)
  gl.Scissor(1, 1, 2, 2)
  gl.Viewport(3, 3, 4, 4)
  gl.Enable(gl.CULL_FACE)
  gl.CullFace(gl.FRONT_AND_BACK)
  gl.Enable(gl.RASTERIZER_DISCARD)
  gl.PolygonMode(gl.FRONT_AND_BACK, gl.POINT)
  gl.DepthFunc(gl.NEVER)
  gl.DepthRange(1, 0)
  gl.Enable(gl.BLEND)
  gl.BlendFunc(gl.ZERO, gl.ZERO)
  gl.Enable(gl.COLOR_LOGIC_OP)
  gl.LogicOp(gl.CLEAR)
  gl.ClipControl(gl.UPPER_LEFT, gl.ZERO_TO_ONE)
  gl.BindFramebuffer(gl.FRAMEBUFFER, gl.GenFramebuffers(1))
  gl.DrawBuffers(0, {})
  gl.BindVertexArray(gl.GenVertexArrays(1))
  gl.BeginQuery(gl.SAMPLES_PASSED, gl.GenQueries(1))
  gl.PixelStorei(gl.PACK_ALIGNMENT, 8)
end
return recipe
)lua";

TEST_F(RecipeFrames, begin_without_what_another_recipe_left) {
  const image::Image alone = picture(stencil_blend_accum);
  picture(wild);
  EXPECT_EQ(picture(stencil_blend_accum), alone);
}

TEST_F(RecipeFrames, begin_without_the_picture_of_another_recipe) {
  picture(drawing("gl.ClearColor(1, 1, 1, 1) gl.Clear(gl.COLOR_BUFFER_BIT) gl.Accum(gl.LOAD, 1)"));
  const image::Image nothing(frame_size, frame_size, {0, 0, 0, 0});
  EXPECT_EQ(picture(drawing("")), nothing);
  EXPECT_EQ(picture(drawing("gl.Accum(gl.RETURN, 1)")), nothing);
}

TEST_F(RecipeFrames, of_one_recipe_are_all_the_same) {
  const RecipeFile file(stencil_blend_accum);
  Recipe recipe(graphics(), file.path());
  recipe.draw();
  const image::Image first = graphics().frame.read_color();
  for (int i = 0; i < 3; ++i) {
    recipe.draw();
    EXPECT_EQ(graphics().frame.read_color(), first);
  }
}

TEST_F(RecipeFrames, of_two_recipes_in_one_context_do_not_mix) {
  const RecipeFile file(stencil_blend_accum), other_file(wild);
  const image::Image alone = picture(stencil_blend_accum);
  Recipe recipe(graphics(), file.path());
  recipe.draw();
  {
    Recipe other(graphics(), other_file.path());
    for (int i = 0; i < 3; ++i) {
      other.draw();
      recipe.draw();
      EXPECT_EQ(graphics().frame.read_color(), alone);
    }
  }
  recipe.draw();
  EXPECT_EQ(graphics().frame.read_color(), alone) << "after the other recipe's end";
}

TEST_F(RecipeFrames, are_the_same_with_captures_a_trace_and_timings) {
  const image::Image alone = picture(stencil_blend_accum);
  const RecipeFile file(stencil_blend_accum);
  Options options;
  options.time_passes = true;
  Recipe recipe(graphics(), file.path(), options);
  gl::Recorder recorder;
  graphics().trace_into(&recorder);
  std::vector<std::size_t> captured;
  recipe.on_pass_end([&](std::size_t pass) {
    captured.push_back(pass);
    graphics().frame.read_color();
    graphics().frame.read_depth();
    graphics().frame.read_stencil();
  });
  recipe.draw();
  graphics().trace_into(nullptr);
  EXPECT_EQ(graphics().frame.read_color(), alone);
  EXPECT_EQ(captured, (std::vector<std::size_t>{0, 1, 2}));
  ASSERT_EQ(recipe.passes().size(), 3u);
  for (const PassTime& pass : recipe.passes()) EXPECT_GT(pass.milliseconds, 0) << pass.name;
  EXPECT_EQ(recorder.passes().size(), 3u);
  EXPECT_GT(recorder.size(), 30u);
}

TEST_F(RecipeFrames, have_no_part_in_setup) {
  const RecipeFile file(
      "local recipe = {}\nfunction recipe.setup() pass('setup', function() gl.Finish() end) end\n"
      "function recipe.draw() pass('draw', function() gl.Flush() end) end return recipe");
  Recipe recipe(graphics(), file.path());
  gl::Recorder recorder;
  graphics().trace_into(&recorder);
  std::size_t ended = 0;
  recipe.on_pass_end([&](std::size_t) { ++ended; });
  recipe.draw();
  graphics().trace_into(nullptr);
  EXPECT_EQ(ended, 1u);
  ASSERT_EQ(recipe.passes().size(), 1u);
  EXPECT_EQ(recipe.passes()[0].name, "draw");
  ASSERT_EQ(recorder.size(), 1u);
  EXPECT_EQ(recorder.call(0).as_c(), "glFlush();");
}

TEST_F(RecipeFrames, keep_the_trace_when_setup_fails) {
  const RecipeFile file("return { setup = function() error 'no' end, draw = print }");
  Recipe recipe(graphics(), file.path());
  gl::Recorder recorder;
  graphics().trace_into(&recorder);
  EXPECT_THROW(recipe.draw(), InputError);
  EXPECT_EQ(graphics().recorder(), &recorder);
  graphics().trace_into(nullptr);
}

TEST_F(RecipeFrames, free_the_buffers_of_meshes_that_are_gone) {
  const RecipeFile file(
      drawing("local flat = shader.load 'flat' for i = 1, 50 do mesh.sphere(1, 64, 32):draw(flat, "
              "{}) end"));
  Recipe recipe(graphics(), file.path());
  for (int i = 0; i < 5; ++i) {
    recipe.draw();
    EXPECT_LE(graphics().meshes.size(), 50u);
    lua_gc(recipe.state().raw(), LUA_GCCOLLECT);
  }
}

TEST_F(RecipeFrames, collect_meshes_that_are_garbage_before_they_run_out_of_memory) {
  // A sphere of 2145 vertices and 4096 triangles is 115 kB; 500 of them exceed 16 MiB.
  Options options;
  options.limits.memory = std::size_t{16} << 20;
  EXPECT_EQ(error(drawing("for i = 1, 500 do mesh.sphere(1, 64, 32) end"), options), "no error");
  EXPECT_NE(
      error(drawing("local t = {} for i = 1, 500 do t[i] = mesh.sphere(1, 64, 32) end"), options)
          .find("needs more than 16 MiB of memory"),
      std::string::npos);
}

}  // namespace
}  // namespace shadowlab::recipe
