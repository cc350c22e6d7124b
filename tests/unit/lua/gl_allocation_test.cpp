// Every binding of every module with each of its allocations failing in turn: no crash, nothing
// kept, and a state that goes on working.
#include "gl_fixture.h"
#include "gl_random.h"

namespace shadowlab::lua {
namespace {

constexpr const char* snippets[] = {
    "return vec2(1, 2) + vec3(1, 2, 3).xy",
    "return vec3(1, 2, 3):cross(vec3(4, 5, 6)):normalize(), tostring(vec4(1, 2, 3, 4))",
    "return mat4.look_at(vec3(1, 2, 3), vec3(0, 0, 0), vec3(0, 1, 0)) * vec4(1, 2, 3, 1)",
    "return mat3.rotate(30, 0, 1, 0):inverse(), mat4.perspective(50, 1, 1, 9):transpose()",
    "return quat.axis_angle(30, 0, 1, 0) * vec3(1, 2, 3)",
    "return shader.load 'phong'",
    "return shader.load 'phnog'",
    "return shader.compile { vertex = '#version 330 core\\nvoid main() { gl_Position = vec4(1); "
    "}', "
    "fragment = '#version 330 core\\nout vec4 f; void main() { f = vec4(1); }' }",
    "return shader.compile { vertex = 'no', fragment = 'no' }",
    "shader.load('flat'):use { color = vec3(1, 0, 0), alpha = 0.5 }",
    "shader.load('flat'):set('colour', 1)",
    "shader.load('phong'):set('normal_matrix', { 1, 2, 3, 4, 5, 6, 7, 8, 9 })",
    "return mesh.plane(1, 2, 3, 4)",
    "return mesh.quad()",
    "return mesh.box(1, 2, 3)",
    "return mesh.sphere(1, 8, 4):transformed(mat4.translate(1, 2, 3))",
    "return mesh.torus(1, 0.2, 8, 4)",
    "return mesh.tetrahedron(1)",
    "return mesh.teapot(1, 1)",
    "return mesh.grid(1, 1, 2, 2, function(c, r) return c * r end)",
    "return mesh.grid(1, 1, 1, 1, { 1, 2, 3, 4 })",
    "return mesh.new { positions = { vec3(0, 0, 0), vec3(1, 0, 0), vec3(0, 1, 0) }, indices = { 0, "
    "1, 2 } }",
    "return mesh.new { positions = { 0, 0, 0 }, indices = { 0, 1, 2 } }",
    "return mesh.obj 'nothing.obj'",
    "local m = mesh.quad() return m:position(0), m:triangle(1)",
    "mesh.quad():draw(shader.load 'flat', { color = vec3(1, 1, 1) })",
    "mesh.quad():draw(shader.load 'flat', { colour = vec3(1, 1, 1) })",
    "return scene.load 'table'",
    "return scene.load 'tabel'",
    "local s = scene.load 'table' return s.camera:view(), s.camera:projection(), s.casters, "
    "s.receivers[1].plane, s.lights, s.objects[1].model, s.camera.eye, s.name",
    "local s = scene.load 'table' s:draw(shader.load 'flat', { view = s.camera:view() })",
    "local s = scene.load 'table' s.caster:draw(shader.load 'flat') "
    "s:object('teapot'):draw(shader.load 'flat')",
    "return scene.load('table'):object('teapto')",
    "return shadow.planar(vec4(0, 1, 0, 0), vec4(1, 2, 3, 1))",
    "return shadow.planar(vec4(0, 1, 0, 0), vec4(1, 0, 3, 1))",
    "return shadow.parallelogram(vec3(0, 0, 0), vec3(1, 0, 0), vec3(0, 0, 1), vec4(1, 2, 3, 1))",
    "return shadow.bias_matrix(), shadow.infinite_perspective(50, 1, 1)",
    "return fbo.depth(8, 8)",
    "return fbo.color(8, 8, gl.RGBA32F)",
    "return fbo.cube_depth(8)",
    "fbo.accumulation 'float32' fbo.accumulation 'snorm16'",
    "pass('a pass', function() gl.Finish() end)",
    "pass('a pass', function() error 'in it' end)",
    "return param.point(1, 2, 3), param.direction(0, 1, 0), param.color(1, 0, 0)",
    "return param.number(1, 0, 2), param.integer(1, 0, 2), param.toggle(true)",
    "return param.choice('a', 'b'), param.choice { 'a', 'b' }",
    "return param.number(3, 0, 2)",
    "return gl.ALWYAS",
    "return gl.GenTextures(20)",
    "return gl.ReadPixels(0, 0, 4, 4, gl.RGBA, gl.UNSIGNED_BYTE)",
};

class Allocations : public GlScript {
 protected:
  struct Sweep {
    std::uint64_t failed = 0;
    std::size_t kept = 0;  ///< bytes more than before
  };

  // Calls the function on the stack's top with each allocation and all after it failing.
  Sweep sweep_top(std::string_view what) {
    lua_State* L = state().raw();
    const auto call = [&](std::uint64_t fails) {
      const std::uint64_t before = state().heap().requests();
      lua_pushvalue(L, 1);
      state().heap().fail_from(fails);
      try {
        state().call(0, 0);
      } catch (const InputError&) {
        // The allocation, or what the snippet shows to be an error.
      }
      state().heap().fail_from(0);
      EXPECT_EQ(lua_gettop(L), 1) << what;
      EXPECT_EQ(stage().pass_name, "") << what;
      EXPECT_EQ(graphics().gl.GetError.pointer(), GLenum{GL_NO_ERROR}) << what;
      return state().heap().requests() - before;
    };
    call(0);  // what is made once, as programs, is there
    lua_gc(L, LUA_GCCOLLECT);
    const std::size_t before = state().heap().bytes();
    Sweep sweep;
    // The first 40 each, then with growing steps: scenes make thousands.
    for (std::uint64_t k = 1; call(k) >= k; k += 1 + k / 40) ++sweep.failed;
    lua_gc(L, LUA_GCCOLLECT);
    const std::size_t after = state().heap().bytes();
    sweep.kept = after > before ? after - before : 0;
    lua_settop(L, 0);
    EXPECT_EQ(value("gl.BindFramebuffer(gl.FRAMEBUFFER, 0) return vec3(1, 2, 3).y + "
                    "#gl.ReadPixels(0, 0, 1, 1, gl.RED, gl.FLOAT)"),
              "3.0")
        << what;
    return sweep;
  }
};

TEST_F(Allocations, of_every_module_may_fail) {
  std::uint64_t failed = 0;
  for (const char* snippet : snippets) {
    state().load_text(snippet, "a.lua");
    const Sweep sweep = sweep_top(snippet);
    EXPECT_GT(sweep.failed, 0u) << snippet;
    // Lua keeps its stack and its table of strings as large as they have been.
    EXPECT_LT(sweep.kept, 8192u) << snippet;
    failed += sweep.failed;
  }
  RecordProperty("allocations", static_cast<int>(failed));
}

TEST_F(Allocations, of_every_function_of_gl_may_fail) {
  run(fill_program);
  run(covering_triangle);
  run(function_tables());
  run(random_calls_in_lua);
  // Mostly right arguments, the same each time, so that what fails moves on through one call.
  run(R"lua(
    local all = functions
    local singles = {}
    for i, f in ipairs(all) do singles[i] = { f } end
    function call_named(index)
      math.randomseed(index)
      functions = singles[index]
      pcall(call_random)
    end
    function count() return #all end
  )lua");
  const int count = std::stoi(value("return count()"));
  ASSERT_GT(count, 150);
  std::uint64_t failed = 0;
  for (int i = 1; i <= count; ++i) {
    const std::string text = "call_named(" + std::to_string(i) + ")";
    state().load_text(text, "a.lua");
    failed += sweep_top(text).failed;
  }
  EXPECT_GT(failed, static_cast<std::uint64_t>(count));
}

}  // namespace
}  // namespace shadowlab::lua
