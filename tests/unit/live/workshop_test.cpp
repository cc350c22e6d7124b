// A recipe that is edited while it runs.
#include <random>

#include "workshop_fixture.h"

namespace shadowlab::live {
namespace {

using Drawn = Workshop::Drawn;

TEST_F(WorkshopTest, a_saved_version_is_drawn_at_the_next_look) {
  write("a.lua", filling(10));
  Workshop workshop(graphics, folder / "a.lua", options);
  EXPECT_EQ(workshop.draw({}), Drawn::picture);
  EXPECT_EQ(pixel()[0], 10);
  EXPECT_FALSE(workshop.look());
  write("a.lua", filling(20));
  EXPECT_EQ(looks_until_tried(workshop), 1);
  EXPECT_EQ(pixel()[0], 20);
  write_by_rename("a.lua", filling(30));
  EXPECT_EQ(looks_until_tried(workshop), 1);
  EXPECT_EQ(pixel()[0], 30);
}

// The system tells of the folder that a file is in, and not of what a link in it leads to.
TEST_F(WorkshopTest, a_file_of_which_the_system_says_nothing_is_drawn_once_it_rests) {
  write("elsewhere/a.lua", filling(10));
  fs::create_symlink(folder / "elsewhere" / "a.lua", folder / "a.lua");
  Workshop workshop(graphics, folder / "a.lua", options);
  workshop.draw({});
  write("elsewhere/a.lua", filling(20));
  EXPECT_EQ(looks_until_tried(workshop), 2);
  EXPECT_EQ(pixel()[0], 20);
}

TEST_F(WorkshopTest, a_file_that_is_saved_unchanged_is_not_drawn_again) {
  write("a.lua", filling(10));
  Workshop workshop(graphics, folder / "a.lua", options);
  workshop.draw({});
  write("a.lua", filling(10));
  EXPECT_EQ(looks_until_tried(workshop), 0);
  EXPECT_EQ(workshop.versions(), 1);
}

TEST_F(WorkshopTest, two_versions_of_one_size_within_a_tick_of_the_clock_are_told_apart) {
  write("a.lua", filling(11));
  Workshop workshop(graphics, folder / "a.lua", options);
  workshop.draw({});
  const auto time = fs::last_write_time(folder / "a.lua");
  write("a.lua", filling(12));
  fs::last_write_time(folder / "a.lua", time);
  EXPECT_GT(looks_until_tried(workshop), 0);
  EXPECT_EQ(pixel()[0], 12);
}

TEST_F(WorkshopTest, a_broken_version_leaves_the_last_one_running) {
  write("a.lua", filling(10));
  Workshop workshop(graphics, folder / "a.lua", options);
  workshop.draw({});
  write("a.lua", "return {");
  EXPECT_EQ(looks_until_tried(workshop), 1);
  ASSERT_TRUE(workshop.failure());
  EXPECT_EQ(workshop.failure()->stage, Failure::Stage::loading);
  // In the same step the last good version drew.
  EXPECT_EQ(pixel()[0], 10);
  EXPECT_EQ(workshop.draw({}), Drawn::picture);
  ASSERT_TRUE(workshop.failure()) << "the error stays until it is mended";
  write("a.lua", filling(20));
  EXPECT_EQ(looks_until_tried(workshop), 1);
  EXPECT_FALSE(workshop.failure());
  EXPECT_EQ(pixel()[0], 20);
}

TEST_F(WorkshopTest, nothing_is_left_of_what_a_failed_version_drew) {
  write("a.lua",
        "local recipe = {}\nfunction recipe.draw() gl.Enable(gl.SCISSOR_TEST)\n"
        "gl.Scissor(8, 8, 8, 8) gl.ClearColor(0, 0, 1, 1) gl.Clear(gl.COLOR_BUFFER_BIT) end\n"
        "return recipe");
  Workshop workshop(graphics, folder / "a.lua", options);
  workshop.draw({});
  const image::Image before = graphics.frame.read_color();
  write("a.lua",
        "local recipe = {}\nfunction recipe.draw() gl.ClearColor(1, 0, 0, 1)\n"
        "gl.Clear(gl.COLOR_BUFFER_BIT) error(\"no\") end\nreturn recipe");
  looks_until_tried(workshop);
  EXPECT_EQ(graphics.frame.read_color(), before);
}

TEST_F(WorkshopTest, an_error_names_its_place_its_pass_and_the_lines_around_it) {
  write("a.lua",
        "local recipe = {}\nfunction recipe.draw()\n  pass(\"one\", function()\n"
        "    gl.Enable(gl.DEPTH_TSET)\n  end)\nend\nreturn recipe\n");
  Workshop workshop(graphics, folder / "a.lua", options);
  EXPECT_EQ(workshop.draw({}), Drawn::nothing);
  ASSERT_TRUE(workshop.failure());
  const Failure& failure = *workshop.failure();
  EXPECT_EQ(failure.stage, Failure::Stage::frame);
  EXPECT_EQ(failure.file, (folder / "a.lua").string());
  EXPECT_EQ(failure.line, 4);
  EXPECT_EQ(failure.pass, "one");
  EXPECT_TRUE(failure.sentence.starts_with("gl.DEPTH_TSET does not exist")) << failure.sentence;
  ASSERT_EQ(failure.around.size(), 7u);
  EXPECT_EQ(failure.around[3].number, 4);
  EXPECT_EQ(failure.around[3].text, "    gl.Enable(gl.DEPTH_TSET)");
}

TEST_F(WorkshopTest, an_error_in_setup_and_one_in_a_shader_say_so) {
  write("a.lua",
        "local recipe = {}\nfunction recipe.setup(r) r.s = shader.load \"mine\" end\n"
        "function recipe.draw() end\nreturn recipe\n");
  write("mine.vert", "#version 330 core\nvoid main() { gl_Position = vec4(0); }\n");
  write("mine.frag", "#version 330 core\nout vec4 c;\nvoid main() { c = vec3(1); }\n");
  Workshop workshop(graphics, folder / "a.lua", options);
  workshop.draw({});
  ASSERT_TRUE(workshop.failure());
  EXPECT_EQ(workshop.failure()->stage, Failure::Stage::setup);
  EXPECT_TRUE(workshop.failure()->file.ends_with("mine.frag")) << workshop.failure()->file;
  EXPECT_EQ(workshop.failure()->line, 3);
}

TEST_F(WorkshopTest, modules_and_shaders_are_watched_and_those_that_are_not_there_yet) {
  write(
      "a.lua",
      "local red = require \"parts.red\"\nlocal recipe = {}\n"
      "function recipe.setup(r) r.s = shader.load \"flat\" end\n"
      "function recipe.draw() gl.ClearColor(red / 255, 0, 0, 1) gl.Clear(gl.COLOR_BUFFER_BIT) end\n"
      "return recipe\n");
  Workshop workshop(graphics, folder / "a.lua", options);
  workshop.draw({});
  ASSERT_TRUE(workshop.failure()) << "there is no parts/red.lua";
  write("parts/red.lua", "return 40");
  EXPECT_GT(looks_until_tried(workshop), 0);
  EXPECT_EQ(pixel()[0], 40);
  write("parts/red.lua", "return 50");
  EXPECT_GT(looks_until_tried(workshop), 0);
  EXPECT_EQ(pixel()[0], 50);
  // Beside the recipe it takes the place of shadowlab's own.
  write("flat.frag", "no shader");
  EXPECT_GT(looks_until_tried(workshop), 0);
  ASSERT_TRUE(workshop.failure());
  EXPECT_EQ(workshop.failure()->stage, Failure::Stage::setup);
}

TEST_F(WorkshopTest, what_was_set_survives_where_it_fits_and_waits_where_it_does_not) {
  write("a.lua", filling(10));
  Workshop workshop(graphics, folder / "a.lua", options);
  workshop.draw({});
  workshop.set("level", "0.8");
  workshop.draw({});
  EXPECT_EQ(pixel()[1], 204);
  const auto with = [&](const std::string& parameter) {
    std::string text = filling(10);
    text.replace(text.find("param.number(0.2, 0, 1)"), 23, parameter);
    write("a.lua", text);
    EXPECT_GT(looks_until_tried(workshop), 0) << parameter;
  };
  with("param.number(0.1, 0, 0.4)");
  EXPECT_EQ(pixel()[1], 102) << "brought into the new range";
  with("nil");
  EXPECT_TRUE(workshop.failure());
  with("param.number(0.6, 0, 1)");
  EXPECT_EQ(pixel()[1], 204);
  workshop.reset_parameters();
  workshop.draw({});
  EXPECT_EQ(pixel()[1], 153) << "0.6: what was set is forgotten";
}

TEST_F(WorkshopTest, a_frame_that_fails_is_not_tried_again_until_something_changes) {
  write("a.lua",
        "local recipe = { params = { on = param.toggle(false) } }\nfunction recipe.draw(r)\n"
        "gl.ClearColor(1, 0, 0, 1) gl.Clear(gl.COLOR_BUFFER_BIT)\n"
        "while r.params.on do end end\nreturn recipe\n");
  Workshop workshop(graphics, folder / "a.lua", options);
  EXPECT_EQ(workshop.draw({}), Drawn::picture);
  workshop.set("on", "true");
  EXPECT_EQ(workshop.draw({}), Drawn::nothing);
  ASSERT_TRUE(workshop.failure());
  EXPECT_EQ(workshop.draw({1.0, {}}), Drawn::nothing);
  workshop.set("on", "false");
  EXPECT_EQ(workshop.draw({}), Drawn::picture);
  EXPECT_FALSE(workshop.failure());
}

TEST_F(WorkshopTest, an_endless_version_ends_when_it_is_mended) {
  options.limits.instructions = lua::uncounted;
  options.limits.seconds = 600;
  const std::string endless =
      "local recipe = {}\nfunction recipe.draw() while true do end end\nreturn recipe\n";
  bool mends = false;
  options.stop = [&] {
    if (std::exchange(mends, false)) write("a.lua", filling(20));
    return false;
  };
  write("a.lua", filling(10));
  Workshop workshop(graphics, folder / "a.lua", options);
  workshop.draw({});
  write("a.lua", endless);
  mends = true;
  EXPECT_GT(looks_until_tried(workshop), 0);
  EXPECT_FALSE(workshop.failure()) << "what was mended is no error";
  EXPECT_TRUE(workshop.look());
  EXPECT_EQ(workshop.draw({}), Drawn::picture);
  EXPECT_EQ(pixel()[0], 20);
}

TEST_F(WorkshopTest, a_recipe_that_goes_away_and_comes_back_is_an_error_in_between) {
  write("a.lua", filling(10));
  Workshop workshop(graphics, folder / "a.lua", options);
  workshop.draw({});
  fs::remove(folder / "a.lua");
  EXPECT_GT(looks_until_tried(workshop), 0);
  ASSERT_TRUE(workshop.failure());
  EXPECT_NE(workshop.failure()->sentence.find("there is no such file"), std::string::npos);
  write("a.lua", filling(60));
  EXPECT_GT(looks_until_tried(workshop), 0);
  EXPECT_FALSE(workshop.failure());
  EXPECT_EQ(pixel()[0], 60);
}

// Good, broken, half-written and endless versions, by writing and by renaming.
TEST_F(WorkshopTest, of_five_hundred_random_edits_the_last_good_one_is_always_shown) {
  std::mt19937 random(7);
  const auto below = [&random](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  int red = 1;
  write("a.lua", filling(red));
  Workshop workshop(graphics, folder / "a.lua", options);
  workshop.draw({});
  workshop.set("level", "0.4");
  for (int edit = 0; edit < 500; ++edit) {
    const int next = 1 + (red + 1 + edit) % 250;
    const std::string first = "-- edit " + std::to_string(edit) + "\n";  // no two are the same
    std::string text = first + filling(next);
    const std::size_t kind = below(5);
    if (kind == 1) {
      const std::size_t whole = text.find("return recipe");
      text.resize(first.size() + below(whole - first.size()));
    }
    if (kind == 2) text.insert(first.size() + below(3) * 7, "(");
    if (kind == 3) text.replace(text.find("gl.Clear("), 9, "while true do end gl.Clear(");
    if (kind == 4) text = "while true do end\n" + text;
    (below(2) ? write("a.lua", text) : write_by_rename("a.lua", text));
    ASSERT_EQ(looks_until_tried(workshop), 1) << "edit " << edit;
    if (kind == 0) red = next;
    ASSERT_EQ(workshop.failure().has_value(), kind != 0) << "edit " << edit << "\n" << text;
    workshop.draw({});
    ASSERT_EQ(pixel()[0], red) << "edit " << edit << "\n" << text;
    ASSERT_EQ(pixel()[1], 102) << "what was set survives";
  }
}

}  // namespace
}  // namespace shadowlab::live
