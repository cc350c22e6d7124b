// shadowlab run: pictures, and what is said where there can be none.
#include <gmock/gmock.h>
#include <unistd.h>

#include <cstring>

#include "image/image.h"
#include "program.h"

namespace shadowlab::cli_tests {
namespace {

constexpr const char* fill = "gl.ClearColor(1, 0, 0, 1) gl.Clear(gl.COLOR_BUFFER_BIT)";

TEST_F(Cli, run_writes_a_picture_of_the_size_asked_for) {
  write_recipe("fill.lua", fill);
  const Ended ended = run("run fill.lua -o out.png --size 7x5");
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(ended.out, "");
  const auto picture = image::read_png(folder / "out.png");
  EXPECT_EQ(picture.width, 7);
  EXPECT_EQ(picture.height, 5);
  EXPECT_EQ(picture.at(3, 2), (std::array<std::uint8_t, 4>{255, 0, 0, 255}));
}

TEST_F(Cli, run_names_the_picture_after_the_recipe) {
  write_recipe("my fill.lua", fill);
  EXPECT_EQ(run("run 'my fill.lua' --size 4").code, 0);
  EXPECT_TRUE(has("my fill.png"));
}

TEST_F(Cli, run_writes_into_folders_with_spaces) {
  write_recipe("fill.lua", fill);
  fs::create_directory(folder / "a b");
  EXPECT_EQ(run("run fill.lua --size 4 -o 'a b/c d.png'").code, 0);
  EXPECT_TRUE(has("a b/c d.png"));
}

TEST_F(Cli, run_writes_the_picture_alone_to_standard_output) {
  write_recipe("fill.lua", std::string("print('hello') ") + fill);
  const Ended ended = run("run fill.lua --size 4 --timings -o - | cat");
  EXPECT_TRUE(ended.out.starts_with("\x89PNG")) << ended.out;
  EXPECT_TRUE(ended.err.starts_with("hello\n")) << ended.err;
}

TEST_F(Cli, run_says_that_the_folder_is_missing_before_it_draws) {
  write_recipe("fill.lua", std::string("print('drawn') ") + fill);
  const Ended ended = run("run fill.lua -o nowhere/out.png");
  expect_sentence(ended, 2, "there is no folder nowhere");
  EXPECT_EQ(ended.out, "");
}

TEST_F(Cli, run_says_that_a_folder_is_read_only) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write anywhere";
  write_recipe("fill.lua", fill);
  fs::create_directory(folder / "locked");
  fs::permissions(folder / "locked", fs::perms::owner_read | fs::perms::owner_exec);
  expect_sentence(run("run fill.lua -o locked/out.png"), 2, "Permission denied");
}

TEST_F(Cli, run_says_where_a_recipe_is_not_lua) {
  write("bad.lua", "local r = {\nreturn r\n");
  expect_sentence(run("run bad.lua -o out.png"), 2, "bad.lua:2: ");
  EXPECT_FALSE(has("out.png"));
}

TEST_F(Cli, run_says_in_which_line_and_pass_a_recipe_fails) {
  write_recipe("bad.lua", "pass('2. the shadow', function()\n  gl.Enable(gl.STENCIL_TST)\nend)");
  const Ended ended = run("run bad.lua -o out.png");
  expect_sentence(ended, 2, "bad.lua:4: in pass \"2. the shadow\"");
  EXPECT_THAT(ended.err, testing::HasSubstr("did you mean gl.STENCIL_TEST?"));
  EXPECT_FALSE(has("out.png"));
}

TEST_F(Cli, run_refuses_what_is_no_recipe) {
  write("empty.lua", "");
  fs::create_directory(folder / "folder");
  write("picture.png", "\x89PNG\r\n\x1a\n");
  expect_sentence(run("run empty.lua"), 2, "returns a table with a function draw");
  expect_sentence(run("run folder"), 2, "folder is a folder");
  expect_sentence(run("run picture.png"), 2, "picture.png:1: ");
  expect_sentence(run("run nothing.lua"), 2, "nothing.lua does not exist");
  expect_sentence(run("run projected_stencl"), 2, "did you mean projected_stencil?");
}

TEST_F(Cli, run_refuses_sizes_that_no_picture_has) {
  write_recipe("fill.lua", fill);
  for (const char* size :
       {"0x4", "4x0", "-1x4", "4x", "x4", "axb", "16385x1", "99999999999x1", "''"})
    expect_sentence(run(std::string("run fill.lua --size ") + size), 2,
                    "--size takes WIDTHxHEIGHT");
}

TEST_F(Cli, run_refuses_settings_that_the_recipe_does_not_take) {
  const std::string command = "run projected_stencil --size 8 -o out.png ";
  expect_sentence(run(command + "--set ligth=1,2,3"), 2, "did you mean light?");
  expect_sentence(run(command + "--set light"), 2, "--set takes NAME=VALUE");
  expect_sentence(run(command + "--set light=1,2"), 2, "three numbers");
  expect_sentence(run(command + "--set light=1,2,x"), 2, "three numbers");
  expect_sentence(run(command + "--set light=nan,inf,0"), 2, "three numbers");
  expect_sentence(run(command + "--set darkness=7"), 2, "from 0 to 1");
  expect_sentence(run(command + "--set"), 2, "--set needs a value");
  EXPECT_FALSE(has("out.png"));
}

TEST_F(Cli, run_refuses_frames_that_are_no_number) {
  write_recipe("fill.lua", fill);
  expect_sentence(run("run fill.lua --frames 0"), 2, "from 1 to 100000");
  expect_sentence(run("run fill.lua --frames many"), 2, "--frames = many");
}

TEST_F(Cli, run_draws_frames_a_sixtieth_of_a_second_apart) {
  write_recipe("time.lua", "print(r.time * 60)");
  EXPECT_EQ(run("run time.lua --size 4 --frames 3").out, "0.0\n1.0\n2.0\n");
}

TEST_F(Cli, run_prints_a_row_of_time_for_each_pass) {
  write_recipe("two.lua", "pass('first', function() end) pass('second', function() end)");
  const Ended ended = run("run two.lua --size 4 --timings");
  EXPECT_THAT(ended.out, testing::MatchesRegex("pass +ms +share\nfirst +[0-9.]+ +[0-9]+%\n"
                                               "second +[0-9.]+ +[0-9]+%\nframe +[0-9.]+\n"));
}

TEST_F(Cli, run_explains_what_each_pass_drew_and_what_it_sent) {
  // A quad is two triangles; its first draw uploads 4 vertices of 32 bytes and 6 indices of 4.
  write("two.lua",
        "local r = {}\n"
        "function r.setup(r) r.quad, r.flat = mesh.quad(), shader.load 'flat' end\n"
        "function r.draw(r)\n"
        "  explain 'said between'\n"
        "  pass('first', function()\n"
        "    explain 'said in the first' explain 'said between'\n"
        "    for i = 1, 3 do r.quad:draw(r.flat) end\n"
        "  end)\n"
        "  pass('second', function() gl.Clear(gl.COLOR_BUFFER_BIT) end)\n"
        "end\nreturn r\n");
  const Ended ended = run("run two.lua --size 4 --explain");
  EXPECT_EQ(ended.out.substr(0, ended.out.find("GL holds")),
            "before and between the passes\n"
            "  said between\n"
            "  Draws nothing; uploads nothing.\n"
            "first\n"
            "  said in the first\n"
            "  3 draws of 6 triangles; 2 uploads of 152 bytes.\n"
            "second\n"
            "  Draws nothing; uploads nothing.\n"
            "the whole frame\n"
            "  3 draws of 6 triangles; 2 uploads of 152 bytes.\n  ");
  // The picture: 4 x 4 pixels of 8 bytes, colour in one texture, depth and stencil in the other.
  EXPECT_THAT(ended.out,
              testing::HasSubstr("GL holds 2 buffers of 152 bytes, 2 textures of 128 bytes and 0 "
                                 "renderbuffers of 0 bytes"));
}

TEST_F(Cli, a_frame_that_nobody_asks_about_says_nothing) {
  write_recipe("one.lua", "explain 'why'");
  EXPECT_EQ(run("run one.lua --size 4").out, "");
  write_recipe("wrong.lua", "explain(1)");
  expect_sentence(run("run wrong.lua --size 4"), 2, "explain takes a sentence");
}

TEST_F(Cli, run_explains_which_caster_needs_zfail) {
  // From the scene's own camera the near plane is lit; from the light's side of the teapot, with
  // the teapot between light and camera, it is not: the light below the table looks up at both.
  const std::string lit = run("run volumes_auto --size 16 --explain -o out.png").out;
  EXPECT_THAT(lit, testing::HasSubstr("z-pass is right for teapot: a plane with normal ("));
  EXPECT_THAT(lit, testing::HasSubstr("and no caps, which z-pass does without."));
  EXPECT_THAT(lit, testing::HasSubstr("1 caster in 1 group"));
  // On the line from the eye (0.35, 3.7, 5.9) through the teapot, beyond it.
  const std::string dark =
      run("run volumes_auto --size 16 --explain --set light=-1.55,-3,-6.1 -o out.png").out;
  EXPECT_THAT(dark, testing::HasSubstr("teapot needs z-fail: its box meets the pyramid"));
  EXPECT_THAT(dark, testing::HasSubstr("triangles of caps, which z-fail needs."));
}

TEST_F(Cli, run_explains_what_a_plan_saves) {
  // Of a hundred houses, volumes of those that shadow nothing seen; twelve triangles each, of three
  // indices of four bytes. The fewer the pixels, the more boxes round to what may be seen.
  const std::string volumes = run("run volumes_zfail --scene city --size 512 --plan --explain").out;
  EXPECT_THAT(volumes, testing::HasSubstr("The plan keeps 29 of 100 casters"));
  EXPECT_THAT(volumes, testing::ContainsRegex("Dropped: 12 casters \\(.*camera's view. Saved: 144 "
                                              "triangles of volumes, 1728 bytes"));
  EXPECT_THAT(volumes, testing::ContainsRegex("Dropped: 59 casters .*pixels at most"));
  // Of the room's four maps the first is before everything.
  const std::string maps =
      run("run shadow_map_cascades --scene room --size 64 --plan --explain").out;
  EXPECT_THAT(maps, testing::ContainsRegex("Map . of 4, 512 × 512 texels, is neither allocated nor "
                                           "drawn, .*262144 pixels.*at least 786432 bytes"));
  EXPECT_THAT(maps,
              testing::ContainsRegex("Map . of 4, 512 × 512 texels: all 2 casters are drawn"));
  const auto passes = [](const std::string& text) {
    std::size_t count = 0;
    for (std::size_t at = 0; (at = text.find("\n1. map ", at)) != std::string::npos; ++at) ++count;
    return count;
  };
  EXPECT_LT(passes(maps), 4u);
  EXPECT_EQ(passes(run("run shadow_map_cascades --scene room --size 64 --explain").out), 4u);
  // A recipe of neither, without a light.
  EXPECT_THAT(run("run fbo_blit --size 64 --plan --explain").out,
              testing::HasSubstr("The plan leaves nothing out"));
}

TEST_F(Cli, a_context_that_is_not_there_ends_with_3) {
  write_recipe("fill.lua", fill);
  expect_sentence(run("run fill.lua --context glfw", "env -u DISPLAY -u WAYLAND_DISPLAY"), 3,
                  "no display");
  expect_sentence(run("run fill.lua --context osmsa"), 2, "did you mean osmesa?");
}

// The header of NumPy's format 1.0, and how many bytes follow it.
struct Array {
  std::string header;
  std::size_t bytes;
};
Array array_of(const fs::path& file) {
  const std::string text = text_of(file);
  EXPECT_TRUE(text.starts_with(std::string("\x93NUMPY\x01\x00", 8))) << file;
  if (text.size() < 10) return {};
  const std::size_t length =
      static_cast<unsigned char>(text[8]) + 256u * static_cast<unsigned char>(text[9]);
  EXPECT_EQ((10 + length) % 64, 0u) << "numpy.lib.format: data begins at a multiple of 64";
  return {text.substr(10, length), text.size() - 10 - length};
}

TEST_F(Cli, captures_are_pictures_and_arrays_of_each_pass) {
  write_recipe(
      "two.lua",
      "pass('1. mark', function() gl.ClearStencil(7) gl.Clear(gl.STENCIL_BUFFER_BIT) end)\n"
      "pass('a \"b\" \\xff', function() end)");
  const Ended ended = run("run two.lua --size 6x4 --captures 'the passes'");
  ASSERT_EQ(ended.code, 0) << ended.err;
  const fs::path captures = folder / "the passes";
  const Array color = array_of(captures / "01_mark.color.npy");
  EXPECT_THAT(color.header, testing::HasSubstr("'descr': '|u1', 'fortran_order': False"));
  EXPECT_THAT(color.header, testing::HasSubstr("'shape': (4, 6, 4"));
  EXPECT_EQ(color.bytes, 4u * 6 * 4);
  const Array depth = array_of(captures / "01_mark.depth.npy");
  EXPECT_THAT(depth.header, testing::HasSubstr("'descr': '<f4'"));
  EXPECT_EQ(depth.bytes, 4u * 6 * sizeof(float));
  const Array stencil = array_of(captures / "01_mark.stencil.npy");
  EXPECT_EQ(stencil.bytes, 4u * 6);
  EXPECT_EQ(text_of(captures / "01_mark.stencil.npy").back(), 7);
  for (const char* name : {"01_mark.depth.png", "02_a_b.color.png", "02_a_b.stencil.png"})
    EXPECT_NO_THROW(image::read_png(captures / name)) << name;
  EXPECT_TRUE(fs::exists(captures / "index.json"));
}

TEST_F(Cli, two_runs_on_any_number_of_threads_give_the_same_files) {
  std::string first;
  for (const char* threads : {"0", "1", "8", "8"}) {
    const std::string name = std::string(threads) + ".png";
    const Ended ended = run("run projected_stencil --size 200x150 --captures c -o " + name,
                            std::string("env LP_NUM_THREADS=") + threads);
    ASSERT_EQ(ended.code, 0) << ended.err;
    std::string all = text_of(folder / name);
    std::vector<fs::path> captures(fs::directory_iterator(folder / "c"), {});
    std::sort(captures.begin(), captures.end());
    for (const auto& file : captures) all += text_of(file);
    if (first.empty()) first = all;
    EXPECT_TRUE(all == first) << threads << " threads";
  }
}

TEST_F(Cli, an_interrupt_leaves_no_part_of_a_file) {
  write_recipe("long.lua", "while true do end");
  const Ended ended = run("run long.lua -o out.png", "timeout -s INT 0.5");
  EXPECT_EQ(ended.code, 124) << ended.err;
  EXPECT_EQ(ended.err, "");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 3) << ".out, .err and the recipe";
}

}  // namespace
}  // namespace shadowlab::cli_tests
