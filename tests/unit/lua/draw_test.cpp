// Shaders and draws from Lua: what reaches the shader, what is refused.
#include <filesystem>
#include <fstream>

#include "gl_fixture.h"

namespace shadowlab::lua {
namespace {

using Shaders = GlScript;
using Draws = GlScript;

// A shader that writes `expression`, a vec4, for drawing mesh.quad().
std::string showing(std::string_view declarations, std::string_view expression) {
  return "local s = shader.compile { vertex = [[#version 330 core\n"
         "layout(location = 0) in vec3 position; void main() { gl_Position = vec4(position, 1); "
         "}]], "
         "fragment = [[#version 330 core\n" +
         std::string(declarations) + " out vec4 f; void main() { f = " + std::string(expression) +
         "; }]] } ";
}

TEST_F(Shaders, with_an_error_name_stage_and_line_of_their_text) {
  EXPECT_EQ(error("shader.compile { vertex = '#version 330 core\\nvoid main() {}', fragment = "
                  "'#version 330 core\\n\\nvoid main() { x = 1; }' }")
                .find("fragment shader:3: "),
            0u);
  EXPECT_EQ(error("shader.compile { vertex = '#version 330 core\\n?', fragment = '' }")
                .find("vertex shader:2: "),
            0u);
  EXPECT_EQ(error("shader.compile { vertex = '' }"),
            "shader.compile needs both vertex and fragment");
  EXPECT_EQ(error("shader.load '../../etc/passwd'").find("there is no file"), 0u);
  EXPECT_EQ(error("shader.load '/etc/passwd'"),
            "a file is named relative to the recipe's folder; \"/etc/passwd.vert\" is not");
}

TEST_F(Shaders, include_files_and_name_the_file_and_line_that_is_wrong) {
  const auto folder = std::filesystem::temp_directory_path() / "shadowlab_includes";
  std::filesystem::create_directories(folder);
  const auto write = [&](const char* name, std::string_view text) {
    std::ofstream(folder / name) << text;
  };
  stage().folders.insert(stage().folders.begin(), folder);
  write("part.glsl", "\nuniform float half_of = 0.5;\nout vec4 f;\n");
  write("a.vert", "#version 330 core\nvoid main() { gl_Position = vec4(0.0); }\n");
  const std::string own = "#version 330 core\n#include \"part.glsl\"\nvoid main() { f = vec4(";
  write("a.frag", own + "half_of); }\n");
  run("shader.load('a'):set('half_of', 0.25)");
  run("shader.compile { vertex = '#version 330 core\\nvoid main() { gl_Position = vec4(0.0); }', "
      "fragment = [[" +
      own + "half_of); }]] }:set('half_of', 0.25)");
  write("a.frag", own + "half_off); }");
  EXPECT_NE(error("shader.load 'a'").find("a.frag:3: "), std::string::npos);
  write("a.frag", own + "half_of); }\n");
  write("part.glsl", "\nuniform float half_of = 0.5;\nout vec5 f;\n");
  EXPECT_NE(error("shader.load 'a'").find("part.glsl:3: "), std::string::npos);
  write("a.frag", "#version 330 core\n#include \"../../etc/passwd\"\n");
  EXPECT_NE(error("shader.load 'a'").find("etc/passwd\""), std::string::npos);  // names it, no more
  std::filesystem::remove_all(folder);
}

TEST_F(Draws, take_arrays_of_vectors_and_matrices) {
  run(showing("uniform mat4 m[2]; uniform vec3 v[2];", "vec4(m[1][3].x, v[1].z, v[0].y, 1)") +
      "mesh.quad():draw(s, { m = { mat4.identity(), mat4.translate(1, 0, 0) }, "
      "v = { vec3(0, 1, 0), vec3(0, 0, 1) } })");
  const image::Image picture = graphics().frame.read_color();
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(picture.rgba[i], 255);
  EXPECT_EQ(error(showing("uniform float a[2];", "vec4(a[1])") +
                  "mesh.quad():draw(s, { a = { 1, 'x' } })"),
            "uniform a takes numbers, vectors or matrices; element 2 is a string");
}

TEST_F(Draws, ignore_what_a_shader_does_not_read_of_an_array) {
  run(showing("uniform float a[3];", "vec4(a[0])") + "mesh.quad():draw(s, { a = { 1, 0, 0 } })");
  EXPECT_EQ(graphics().frame.read_color().rgba[0], 255);
  EXPECT_EQ(error(showing("uniform vec2 a[3];", "vec4(a[0].x)") +
                  "mesh.quad():draw(s, { a = { 1, 0, 0 } })"),
            "uniform a takes 2 numbers; 3 given");
}

TEST_F(Draws, refuse_uniforms_that_no_stage_declares_and_ignore_dropped_ones) {
  EXPECT_EQ(error("mesh.quad():draw(shader.load 'flat', { colour = vec3(1, 0, 0) })"),
            "the shader declares no uniform colour; did you mean color?");
  run(showing("uniform float unused;", "vec4(1)") + "mesh.quad():draw(s, { unused = 1 })");
  EXPECT_EQ(error("mesh.quad():draw(shader.load 'flat', { color = vec2(1, 0) })"),
            "uniform color takes 3 numbers; 2 given");
  EXPECT_EQ(error("mesh.quad():draw(shader.load 'flat', { alpha = 1/0 })"),
            "uniform alpha would be inf, which is not a finite float");
  EXPECT_EQ(error("mesh.quad():draw(shader.load 'flat', { model = 1 })").find("model must be"), 0u);
  EXPECT_EQ(error("mesh.quad():draw(shader.load 'flat', { 1 })"),
            "a draw's table has uniforms by name; a number is no name");
  EXPECT_EQ(error("mesh.quad():draw(7)"),
            "what a draw is given first must be a shader; it is a "
            "number");
}

TEST_F(Draws, hand_the_shader_products_of_doubles) {
  // Far from the origin the floats of view and model would cancel to nothing.
  run(showing("uniform mat4 model_view;", "vec4(model_view[3].xyz / 4, 1)") +
      "mesh.quad():draw(s, { model = mat4.translate(1e9 + 1, 2, 3), view = mat4.translate(-1e9, 0, "
      "0) })");
  EXPECT_EQ(graphics().frame.read_color().at(0, 0),
            (std::array<std::uint8_t, 4>{64, 128, 191, 255}));
}

TEST_F(Draws, give_normals_of_flattened_models_no_inverse) {
  const std::string shows = showing("uniform mat3 normal_matrix;", "vec4(normal_matrix[0], 1)");
  run(shows + "mesh.quad():draw(s, { model = mat4.scale(0.5, 0, 1) })");
  EXPECT_EQ(graphics().frame.read_color().at(0, 0), (std::array<std::uint8_t, 4>{128, 0, 0, 255}));
  // A determinant that is not 0 in double, whose inverse is no float.
  run(shows + "mesh.quad():draw(s, { model = mat4.scale(0.5, 1e-60, 1) })");
  EXPECT_EQ(graphics().frame.read_color().at(0, 0), (std::array<std::uint8_t, 4>{128, 0, 0, 255}));
  run(shows + "mesh.quad():draw(s, { model = mat4.scale(2, 4, 8) })");
  EXPECT_EQ(graphics().frame.read_color().at(0, 0), (std::array<std::uint8_t, 4>{128, 0, 0, 255}));
}

TEST_F(Draws, into_an_incomplete_framebuffer_say_so) {
  EXPECT_EQ(error("gl.BindFramebuffer(gl.FRAMEBUFFER, gl.GenFramebuffers(1)) "
                  "mesh.quad():draw(shader.load 'flat', {})"),
            "drawing mesh: the framebuffer is not complete "
            "(gl.FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT)");
}

TEST_F(Draws, keep_their_own_values_after_gl_uniform) {
  run(showing("uniform vec4 shown;", "shown") +
      "s:use { shown = { 0, 1, 0, 1 } } for location = 0, 7 do pcall(gl.Uniform4f, location, 1, 0, "
      "0, 1) end mesh.quad():draw(s, {})");
  EXPECT_EQ(graphics().frame.read_color().at(0, 0), (std::array<std::uint8_t, 4>{0, 255, 0, 255}));
}

}  // namespace
}  // namespace shadowlab::lua
