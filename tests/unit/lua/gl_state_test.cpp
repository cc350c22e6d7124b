// State: what a frame begins with, and what the core leaves as it was.
#include "gl_fixture.h"
#include "gl_random.h"
#include "gl_snapshot.h"

namespace shadowlab::lua {
namespace {

constexpr int seeds = 60;
constexpr int calls_of_a_seed = 300;

class GlState : public GlScript {
 protected:
  // Leaves wild but valid state behind.
  void call_randomly(int seed) {
    stop();
    start({});
    run(fill_program);
    run(covering_triangle);
    run(function_tables());
    run("math.randomseed(" + std::to_string(seed) + ")" + random_calls_in_lua + "for i = 1, " +
        std::to_string(calls_of_a_seed) + " do call_random() end");
    accepted_ += std::stoi(value("return accepted"));
  }

  // What these lines draw in a frame of their own.
  image::Image picture() {
    stop();
    start({});
    run(R"lua(
      gl.ClearColor(0.3, 0.4, 0.5, 1)
      gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT)
      local table = scene.load 'table'
      local phong = shader.load 'phong'
      table:draw(phong, { view = table.camera:view(), projection = table.camera:projection(1),
                          light = vec4(2, 4, 1, 1) })
      gl.Accum(gl.LOAD, 0.5)
      gl.Accum(gl.RETURN, 1.5)
    )lua");
    return graphics().frame.read_color();
  }

  int accepted_ = 0;
};

TEST_F(GlState, is_back_to_gls_defaults_when_a_frame_begins) {
  graphics().begin_frame();
  const Snapshot fresh(graphics());
  const image::Image fresh_picture = picture();
  for (int seed = 1; seed <= seeds; ++seed) {
    call_randomly(seed);
    graphics().begin_frame();
    ASSERT_EQ(difference(fresh, Snapshot(graphics())), "") << "seed " << seed;
    if (seed % 10 == 0) {
      ASSERT_EQ(picture(), fresh_picture) << "seed " << seed;
    }
  }
  // The calls were not all refused, or nothing would have been shown.
  EXPECT_GT(accepted_, seeds * calls_of_a_seed / 3);
}

TEST_F(GlState, of_a_frame_is_that_of_a_new_context) {
  const Snapshot here(graphics());
  gl::Graphics other(context::create(), frame_size, frame_size);
  other.begin_frame();
  EXPECT_EQ(difference(Snapshot(other), here), "");
  graphics().begin_frame();
}

TEST_F(GlState, stays_as_it_is_when_the_core_looks_or_draws_for_itself) {
  const scene::Mesh quad = scene::quad();
  for (int seed = 1; seed <= seeds; ++seed) {
    call_randomly(seed);
    // The main frame bound, a query ended: as gl.Accum asks.
    run("gl.BindFramebuffer(gl.FRAMEBUFFER, 0) for _, t in ipairs(enums.QueryTarget) do "
        "pcall(gl.EndQuery, t) end");
    const Snapshot before(graphics());
    const auto color = graphics().frame.read_color();
    const auto depth = graphics().frame.read_depth();
    const auto stencil = graphics().frame.read_stencil();
    ASSERT_EQ(difference(before, Snapshot(graphics())), "") << "reading back, seed " << seed;
    for (const GLenum operation : {GL_LOAD, GL_ACCUM, GL_ADD, GL_MULT})
      graphics().accumulation.run(operation, 0.5f);
    graphics().accumulation.clear();
    ASSERT_EQ(difference(before, Snapshot(graphics())), "") << "accumulating, seed " << seed;
    graphics().meshes.get(std::make_shared<const scene::Mesh>(quad));
    ASSERT_EQ(difference(before, Snapshot(graphics())), "") << "making buffers, seed " << seed;
    ASSERT_EQ(graphics().frame.read_color(), color) << "seed " << seed;
    ASSERT_EQ(graphics().frame.read_depth().values, depth.values) << "seed " << seed;
    ASSERT_EQ(graphics().frame.read_stencil(), stencil) << "seed " << seed;
    graphics().accumulation.run(GL_RETURN, 1);
    ASSERT_EQ(difference(before, Snapshot(graphics())), "") << "RETURN, seed " << seed;
  }
}

TEST_F(GlState, and_pixels_are_the_same_with_and_without_a_trace) {
  // In contexts of their own, so that objects have the same names.
  gl::Graphics plain(context::create(), frame_size, frame_size);
  gl::Graphics traced(context::create(), frame_size, frame_size);
  for (const int seed : {7, 8, 9}) {
    use(plain);
    call_randomly(seed);
    const auto picture = plain.frame.read_color();
    const Snapshot untraced(plain);
    stop();
    use(traced);
    gl::Recorder recorder;
    traced.trace_into(&recorder);
    call_randomly(seed);
    traced.trace_into(nullptr);
    EXPECT_GT(recorder.size(), 100u);
    EXPECT_EQ(difference(untraced, Snapshot(traced)), "") << "seed " << seed;
    EXPECT_EQ(traced.frame.read_color(), picture) << "seed " << seed;
    stop();
  }
}

// ---- anything at all

TEST_F(GlState, survives_anything_that_a_script_can_pass) {
  constexpr int rounds = 12, calls = 2500;
  const image::Image fresh_picture = picture();
  for (int seed = 1; seed <= rounds; ++seed) {
    stop();
    start({});
    run(fill_program);
    run(covering_triangle);
    run(function_tables());
    run("math.randomseed(" + std::to_string(1000 + seed) + ")" + random_calls_in_lua +
        "for i = 1, " + std::to_string(calls) + " do call_random(i % 2 == 0) end");
    EXPECT_GT(std::stoi(value("return accepted")), calls / 8);
    EXPECT_GT(std::stoi(value("return refused")), calls / 8);
    ASSERT_EQ(graphics().gl.GetError.pointer(), GLenum{GL_NO_ERROR});
    graphics().begin_frame();
    ASSERT_EQ(picture(), fresh_picture) << "seed " << seed;
  }
}

}  // namespace
}  // namespace shadowlab::lua
