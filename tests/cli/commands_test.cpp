// The other commands, and the command line itself.
#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "image/image.h"
#include "program.h"

namespace shadowlab::cli_tests {
namespace {

using testing::HasSubstr;

TEST_F(Cli, without_a_command_it_shows_its_help_and_ends_with_2) {
  const Ended ended = run("");
  EXPECT_EQ(ended.code, 2);
  EXPECT_EQ(ended.out, "");
  EXPECT_THAT(ended.err, HasSubstr("Usage: shadowlab"));
}

TEST_F(Cli, a_mistyped_command_or_option_names_the_near_one) {
  expect_sentence(run("runn"), 2, "there is no command runn; did you mean run?");
  expect_sentence(run("run x --sizee 4"), 2, "did you mean --size?");
  expect_sentence(run("list recipez"), 2, "did you mean recipes?");
  expect_sentence(run("--bogus"), 2, "does not take --bogus");
  expect_sentence(run("run"), 2, "run needs RECIPE");
}

TEST_F(Cli, every_command_has_a_help_with_an_example) {
  for (const char* command :
       {"run", "trace", "list", "new", "gallery", "diff", "measure", "stress", "doctor"}) {
    const Ended ended = run(std::string(command) + " --help");
    EXPECT_EQ(ended.code, 0) << command;
    EXPECT_THAT(ended.out, HasSubstr(std::string("Example:\n  shadowlab ") + command));
  }
}

TEST_F(Cli, a_full_disk_behind_standard_output_ends_with_2) {
  expect_sentence(run("list recipes > /dev/full"), 2, "cannot write to standard output");
}

// What a trace lists between the heading of pass `number` and the next.
std::string pass_of(const std::string& trace, int number) {
  const auto heading = [&](int n) { return trace.find("/* " + std::to_string(n) + ". "); };
  const std::size_t begin = heading(number), end = heading(number + 1);
  return begin == std::string::npos ? "" : trace.substr(begin, end - begin);
}

TEST_F(Cli, check_of_all_scenes_has_a_row_for_each) {
  const Ended ended = run("check shadow_map_fbo --scene all --size 8");
  const Ended listed = run("list scenes");
  EXPECT_LE(ended.code, 1) << ended.err;
  // The check has a heading.
  EXPECT_EQ(std::ranges::count(ended.out, '\n'), 1 + std::ranges::count(listed.out, '\n'))
      << ended.out << listed.out;
}

TEST_F(Cli, trace_prints_the_lectures_calls_pass_by_pass) {
  const Ended ended = run("trace projected_stencil --size 64");
  ASSERT_EQ(ended.code, 0) << ended.err;
  // 000_178f3ee06912f876, "Ombres per projecció (amb stencil)"; masks are the recipe's choice.
  const std::vector<std::vector<std::string>> passes{
      {"  glEnable(GL_STENCIL_TEST);\n", "  glStencilFunc(GL_ALWAYS, 1, 0x",
       "  glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);\n", "  glDrawElements(GL_TRIANGLES, "},
      {"  glDisable(GL_DEPTH_TEST);\n", "  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);\n",
       "  glStencilFunc(GL_EQUAL, 1, 0x", "  glStencilOp(GL_KEEP, GL_KEEP, GL_ZERO);\n",
       "  glDrawElements(GL_TRIANGLES, "},
      {"  glEnable(GL_DEPTH_TEST);\n", "  glDepthFunc(GL_LEQUAL);\n",
       "  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);\n", "  glStencilFunc(GL_EQUAL, 0, 0x",
       "  glDrawElements(GL_TRIANGLES, "},
      {"  glDepthFunc(GL_LESS);\n", "  glDisable(GL_STENCIL_TEST);\n",
       "  glDrawElements(GL_TRIANGLES, "}};
  for (std::size_t i = 0; i < passes.size(); ++i) {
    const std::string pass = pass_of(ended.out, static_cast<int>(i) + 1);
    for (const std::string& line : passes[i]) EXPECT_THAT(pass, HasSubstr(line));
    // State is set before anything is drawn with it.
    EXPECT_GT(pass.find("glDrawElements"), pass.find(passes[i].front()));
  }
  EXPECT_EQ(pass_of(ended.out, 5), "");
}

TEST_F(Cli, trace_as_json_has_every_call_that_the_text_has) {
  write_recipe("two.lua",
               "print('not JSON')\n"
               "gl.ClearStencil(3)\n"
               "pass('a */ \"b\" \\xff', function() gl.StencilFunc(gl.EQUAL, 1, 0xFF) end)");
  const Ended ended = run("trace two.lua --size 4 --json");
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(ended.err, "not JSON\n");
  const auto trace = nlohmann::json::parse(ended.out);
  ASSERT_EQ(trace["calls"].size(), 2u);
  EXPECT_EQ(trace["calls"][0]["pass"], nullptr);
  EXPECT_EQ(trace["calls"][1]["pass"], trace["passes"][0]);
  EXPECT_EQ(trace["calls"][1]["function"], "glStencilFunc");
  EXPECT_EQ(trace["calls"][1]["arguments"], nlohmann::json({"GL_EQUAL", "1", "0xFF"}));
  EXPECT_EQ(run("trace two.lua --size 4").out,
            "glClearStencil(3);\n\n/* a * / \"b\" \xff */\n  glStencilFunc(GL_EQUAL, 1, 0xFF);\n");
}

TEST_F(Cli, trace_shows_what_came_before_a_fault) {
  write_recipe("bad.lua", "gl.ClearStencil(3)\ngl.ClearStencil('x')");
  const Ended ended = run("trace bad.lua --size 4");
  EXPECT_EQ(ended.out, "glClearStencil(3);\n");
  expect_sentence(ended, 2, "bad.lua:4: ");
}

TEST_F(Cli, trace_into_a_closed_pipe_says_nothing) {
  const Ended ended = run("trace projected_stencil --size 8 | head -n 1");
  EXPECT_EQ(ended.err, "");
  EXPECT_EQ(std::count(ended.out.begin(), ended.out.end(), '\n'), 1);
}

TEST_F(Cli, list_shows_titles_and_why_a_recipe_does_not_load) {
  fs::create_directories(folder / "home/scripts/scenes");
  write("home/scripts/good.lua", "return { title = 'A title', draw = function() end }");
  write("home/scripts/bad.lua", "return 7");
  write("home/scripts/scenes/broken.lua", "return {}");
  const Ended recipes = run("list recipes", "env SHADOWLAB_HOME=home");
  EXPECT_EQ(recipes.code, 0) << recipes.err;
  EXPECT_THAT(recipes.out, testing::StartsWith("bad   does not load: "));
  EXPECT_THAT(recipes.out, HasSubstr("\ngood  A title\n"));
  EXPECT_THAT(run("list scenes", "env SHADOWLAB_HOME=home").out,
              HasSubstr("broken  does not load"));
  EXPECT_THAT(run("list scenes").out, HasSubstr("A teapot over a table-top"));
}

TEST_F(Cli, a_home_without_scripts_ends_with_3) {
  expect_sentence(run("list", "env SHADOWLAB_HOME=nowhere"), 3, "set SHADOWLAB_HOME");
}

TEST_F(Cli, new_writes_a_recipe_that_runs_and_overwrites_none) {
  const Ended made = run("new recipe my_shadow");
  EXPECT_EQ(made.code, 0) << made.err;
  const std::string text = text_of(folder / "my_shadow.lua");
  EXPECT_THAT(text, HasSubstr("title  = \"My shadow\""));
  const Ended drawn = run("run my_shadow.lua --size 32 --set light=1,3,2");
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  expect_sentence(run("new recipe my_shadow"), 2, "exists already");
  expect_sentence(run("new recipe my_shadow.lua"), 2, "exists already");
  EXPECT_EQ(text_of(folder / "my_shadow.lua"), text);
  expect_sentence(run("new recipe 'a\"b'"), 2, "is no name");
  expect_sentence(run("new recipe nowhere/x"), 2, "there is no folder nowhere");
}

TEST_F(Cli, the_reference_names_everything_that_a_recipe_sees) {
  write_recipe(
      "names.lua",
      "for _, module in ipairs { 'gl', 'shader', 'mesh', 'scene', 'shadow', 'fbo', 'param',\n"
      "    'vec2', 'vec3', 'vec4', 'mat3', 'mat4', 'quat' } do\n"
      "  for name in pairs(_G[module]) do print(module .. '.' .. name) end\n"
      "end");
  const Ended ended = run("run names.lua --size 4");
  ASSERT_EQ(ended.code, 0) << ended.err;
  const std::string reference = text_of(SHADOWLAB_SOURCE_DIR "/docs/lua-api.md");
  std::istringstream names(ended.out);
  int count = 0;
  for (std::string name; std::getline(names, name); ++count) {
    // Methods of vectors and matrices are listed as they are called: v:dot(u).
    const std::string method = ":" + name.substr(name.find('.') + 1) + "(";
    const bool found = reference.find(name) != std::string::npos ||
                       (name[0] != 'g' && reference.find(method) != std::string::npos);
    EXPECT_TRUE(found) << name;
  }
  EXPECT_GT(count, 500);
}

TEST_F(Cli, diff_ends_with_0_where_pictures_are_alike_and_1_where_not) {
  image::Image a(4, 4, {100, 100, 100, 255});
  image::write_png(folder / "a.png", a);
  a.set(1, 1, {103, 100, 100, 0});
  image::write_png(folder / "three.png", a);
  a.set(1, 1, {104, 100, 100, 255});
  image::write_png(folder / "four.png", a);
  image::write_png(folder / "small.png", image::Image(2, 2));
  EXPECT_EQ(run("diff a.png a.png").code, 0);
  EXPECT_EQ(run("diff a.png three.png").code, 0) << "3/255 is tolerated";
  const Ended four = run("diff a.png four.png -o heat.png");
  EXPECT_EQ(four.code, 1);
  EXPECT_THAT(four.out, HasSubstr("1 of 16 pixels"));
  EXPECT_THAT(four.out, HasSubstr("worst      4/255"));
  EXPECT_EQ(image::read_png(folder / "heat.png").width, 4);
  EXPECT_EQ(run("diff a.png four.png --tolerance 4").code, 0);
  EXPECT_EQ(run("diff a.png three.png --tolerance 0").code, 1);
  // √(4² / 48) / 255 is 0.0023: under 3/255, over 0.5/255.
  EXPECT_EQ(run("diff a.png four.png --metric rmse").code, 0);
  EXPECT_EQ(run("diff a.png four.png --metric rmse --tolerance 0.5").code, 1);
  EXPECT_EQ(run("diff a.png a.png --metric flip --tolerance 0").code, 0);
  EXPECT_EQ(run("diff a.png four.png --metric flip --tolerance 0").code, 1);
  expect_sentence(run("diff a.png small.png"), 2, "4 x 4");
  expect_sentence(run("diff a.png nothing.png"), 2, "nothing.png");
  expect_sentence(run("diff a.png four.png --metric mse"), 2, "did you mean rmse?");
}

TEST_F(Cli, gallery_shows_every_recipe_and_survives_a_failing_one) {
  fs::create_directories(folder / "home/scripts");
  write("home/scripts/a b#.lua",
        "return { title = '<b>&\"', draw = function() pass('1. <i>', function() end) end }");
  write("home/scripts/bad.lua", "return { title = 'Bad', draw = function() error('x < y') end }");
  const Ended ended = run("gallery -o 'the gallery' --size 16", "env SHADOWLAB_HOME=home");
  EXPECT_EQ(ended.code, 1);
  EXPECT_EQ(ended.out, "2 recipes: the gallery/index.html\n");
  expect_sentence(ended, 1, "bad is not drawn: home/scripts/bad.lua:1: x < y");
  const std::string page = text_of(folder / "the gallery/index.html");
  EXPECT_THAT(page, HasSubstr("&lt;b&gt;&amp;&quot;"));
  EXPECT_THAT(page, HasSubstr("<figcaption>1. &lt;i&gt;</figcaption>"));
  EXPECT_THAT(page, HasSubstr("Not drawn: home/scripts/bad.lua:1: x &lt; y"));
  EXPECT_THAT(page, HasSubstr("src=\"a%20b%23.png\""));
  EXPECT_THAT(page, HasSubstr("href=\"../home/scripts/a%20b%23.lua\""));
  EXPECT_THAT(page, testing::Not(HasSubstr("http"))) << "nothing is fetched";
  EXPECT_TRUE(has("the gallery/a b#.png"));
  EXPECT_TRUE(has("the gallery/a b#/01_i.color.png"));
}

TEST_F(Cli, doctor_lists_each_context_and_what_else_matters) {
  const Ended ended = run("doctor", "env -u DISPLAY -u WAYLAND_DISPLAY");
  EXPECT_EQ(ended.code, 0) << ended.err;
  for (const char* name :
       {"OSMesa", "EGL", "GLFW", "shader cache", "threads", "scripts", "isolation"})
    EXPECT_THAT(ended.out, HasSubstr(name));
}

TEST_F(Cli, where_no_context_works_doctor_and_run_end_with_3) {
  fs::create_directory(folder / "broken");
  for (const char* library : {"libOSMesa.so.8", "libEGL.so.1", "libglfw.so.3"})
    write(std::string("broken/") + library, "");  // an empty file does not load
  const Ended ended = run("doctor", "env LD_LIBRARY_PATH=broken");
  expect_sentence(ended, 3, "apt-get install libosmesa6");
  EXPECT_THAT(ended.out, HasSubstr("OSMesa: libOSMesa.so.8 does not load"));
  write_recipe("fill.lua", "");
  expect_sentence(run("run fill.lua", "env LD_LIBRARY_PATH=broken"), 3,
                  "No OpenGL context can be made here");
}

}  // namespace
}  // namespace shadowlab::cli_tests
