// Each allocation of each binding fails in turn: nothing leaks (the sanitizers tell), nothing
// crashes, and the state works afterwards.
#include "gl_fixture.h"
#include "gl_random.h"

namespace shadowlab::lua {
namespace {

// A snippet for each function of the modules; gl.* follows from its list.
constexpr const char* snippets[] = {
    "return shader.load 'phong'",
    "return shader.compile{ vertex = v, fragment = f }",
    "s:use{ color = vec3(1, 0, 0) }",
    "s:set('color', {1, 0, 0})",
    "return mesh.plane(1, 2, 2, 2)",
    "return mesh.quad()",
    "return mesh.box(1, 2, 3)",
    "return mesh.sphere(1, 6, 4)",
    "return mesh.torus(1, 0.2, 5, 4)",
    "return mesh.tetrahedron(1)",
    "return mesh.teapot(1, 1)",
    "return mesh.grid(1, 1, 2, 2, function(c, r) return c * r end)",
    "return mesh.new{ positions = {0, 0, 0, 1, 0, 0, 0, 1, 0}, indices = {0, 1, 2} }",
    "return m:transformed(mat4.translate(1, 2, 3))",
    "return m:position(0), m:triangle(0), m.vertices, m.low, tostring(m)",
    "m:draw(s, { view = mat4.identity(), color = vec3(1) })",
    "return scene.load 'tetra'",
    "return sc.objects, sc.casters, sc.receivers, sc.lights, sc.caster, sc.camera, sc.name",
    "return sc:object('tetrahedron').model, sc.objects[1].plane",
    "sc:draw(s, { view = sc.camera:view(), projection = sc.camera:projection(1) })",
    "sc.caster:draw(s, {})",
    "return shadow.planar(vec4(0, 1, 0, 0), vec4(1, 2, 3, 1))",
    "return shadow.planar_from_origin(vec4(0, 1, 0, 1)), shadow.planar_along(vec4(0, 1, 0, 0), "
    "vec3(0, 1, 0))",
    "return shadow.planar_from_point(vec4(0, 1, 0, 0), vec3(0, 1, 0))",
    "return shadow.parallelogram(vec3(0, 0, 0), vec3(1, 0, 0), vec3(0, 0, 1), vec4(0, 3, 0, 1))",
    "return shadow.bias_matrix(), shadow.infinite_perspective(45, 1, 0.1)",
    "return shadow.volume(m, mat4.identity(), vec4(1, 5, 1, 1), { edges = 'silhouette' })",
    "return shadow.volume(m, mat4.identity(), vec4(1, 5, 1, 1), { edges = 'all' }).triangles",
    "shadow.volume(m, mat4.identity(), vec4(1, 5, 1, 1)):draw(volume_shader, {})",
    "shadow.volume(m, mat4.identity(), vec4(1, 5, 1, 1)):draw_unlit(volume_shader, {})",
    "return shadow.adjacency(m), shadow.layers(m)",
    "return shadow.silhouette(m, mat4.identity(), vec4(1, 5, 1, 1))",
    "return shadow.needs_zfail(sc.camera, vec4(1, 5, 1, 1), sc.casters[1])",
    "return shadow.truth(sc, sc.camera, vec4(2, 4, 1, 1))",
    "return fbo.depth(4, 4), fbo.color(4, 4, gl.RGBA16F), fbo.cube_depth(4)",
    "fbo.accumulation 'float32'",
    "pass('a pass', function() return {} end)",
    "return param.point(1, 2, 3), param.choice('a', 'b'), param.number(1, 0, 2), "
    "param.toggle(true)",
    "return param.direction(1, 2, 3), param.integer(1, 0, 2), param.color(1, 0, 0)",
    "return vec3(1, 2, 3):cross(vec3(0, 1, 0)), tostring(mat4.look_at(vec3(1), vec3(0), vec3(0, 1, "
    "0)))",
};

class BindingsAllocation : public GlScript {
 protected:
  void SetUp() override {
    GlScript::SetUp();
    run(R"(
      v = 'void main() { gl_Position = vec4(0); }'
      f = 'uniform vec3 color; out vec4 o; void main() { o = vec4(color, 1); }'
      v, f = '#version 330 core\n' .. v, '#version 330 core\n' .. f
      s, volume_shader = shader.load 'phong', shader.load 'volume'
      m, sc = mesh.tetrahedron(1), scene.load 'tetra')");
  }

  void run(std::string_view text) {
    state().load_text(text, "sweep.lua");
    state().call(0, 0);
  }

  // Runs with the k-th allocation failing, k = 1, 2, … until none is left to fail; how often it
  // did.
  int sweep(const std::string& text, int most) {
    for (int k = 1; k <= most; ++k) {
      state().load_text(text, "sweep.lua");
      bool failed = false;
      state().heap().fail_from(static_cast<std::uint64_t>(k));
      try {
        state().call(0, 0);
      } catch (const InputError&) {
        failed = true;
      }
      state().heap().fail_from(0);
      lua_settop(state().raw(), 0);
      run("assert(1 + 1 == 2)");
      if (!failed) return k - 1;
    }
    return most;
  }
};

TEST_F(BindingsAllocation, each_that_fails_in_a_module_is_a_sentence_and_nothing_more) {
  int failures = 0;
  for (const char* snippet : snippets) {
    const int failed = sweep(snippet, 400);
    EXPECT_LT(failed, 400) << snippet << " never succeeds";
    failures += failed;
  }
  EXPECT_GT(failures, 200);
  EXPECT_EQ(graphics().gl.GetError.pointer(), GLenum{GL_NO_ERROR});
}

// Random calls that are mostly right: each function several times, seeded by the state.
TEST_F(BindingsAllocation, each_that_fails_in_gl_is_a_sentence_and_nothing_more) {
  run(function_tables() + random_calls_in_lua);
  for (int i = 0; i < 600; ++i) sweep("call_random(false)", 12);
  run("assert(accepted > 300, accepted)");
}

}  // namespace
}  // namespace shadowlab::lua
