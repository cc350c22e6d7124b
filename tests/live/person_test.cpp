// The window as a person uses it, against the pictures that `run` makes.
#include <regex>

#include "desktop.h"

namespace shadowlab::live_tests {
namespace {

class Person : public Desktop {
 protected:
  // The lecture's four passes over a small picture, the file beside us.
  static constexpr const char* options = " --size 160x120";

  void copy_recipe() const {
    fs::copy_file(fs::path(SHADOWLAB_SOURCE_DIR) / "scripts" / "projected_stencil.lua",
                  folder / "mine.lua");
  }
  std::string recipe() const { return text_of(folder / "mine.lua"); }

  image::Image picture(const std::string& arguments = "") const {
    EXPECT_EQ(run(std::string("run mine.lua -o picture.png") + options + " " + arguments), 0);
    return image::read_png(folder / "picture.png");
  }

  // Nothing but the picture, a pixel for a pixel.
  void show_alone() { press("F2 ctrl+1"); }

  void edit(const std::string& from, const std::string& to) const {
    std::string text = recipe();
    const auto at = text.find(from);
    ASSERT_NE(at, std::string::npos);
    write("new.lua", text.replace(at, from.size(), to));
    fs::rename(folder / "new.lua", folder / "mine.lua");
  }
};

TEST_F(Person, sees_the_picture_of_run_and_quits) {
  copy_recipe();
  open(std::string("mine.lua") + options);
  show_alone();
  const image::Image expected = picture();
  EXPECT_TRUE(soon([&] { return shows(expected); }));
  press("Escape");
  EXPECT_EQ(ended(), 0) << said();
}

TEST_F(Person, saves_and_sees_the_new_picture_and_an_error_over_the_last_one) {
  copy_recipe();
  open(std::string("mine.lua") + options);
  show_alone();
  edit("param.number(0.35, 0, 1)", "param.number(0.9, 0, 1)");
  const image::Image saved = picture();
  EXPECT_TRUE(soon([&] { return shows(saved); }));
  edit("gl.Enable(gl.DEPTH_TEST)", "gl.Enable(gl.DEPTH_TSET)");
  EXPECT_TRUE(soon([&] { return title().find("error") != std::string::npos; }));
  EXPECT_TRUE(soon([&] { return shows(saved); })) << "the last good picture stands";
  edit("gl.Enable(gl.DEPTH_TSET)", "while true do end");
  EXPECT_TRUE(soon([&] { return title().find("error") != std::string::npos; }));
  edit("while true do end", "gl.Enable(gl.DEPTH_TEST)");
  EXPECT_TRUE(soon([&] { return title().find("error") == std::string::npos; }));
  EXPECT_TRUE(soon([&] { return shows(saved); }));
  press("ctrl+q");
  EXPECT_EQ(ended(), 0) << said();
}

// With a limit that no test waits for: the window listens while the recipe runs.
TEST_F(Person, mends_stops_and_quits_an_endless_recipe) {
  copy_recipe();
  open(std::string("mine.lua --limit 6000") + options);
  show_alone();
  const auto draws_on = [&] {
    return soon([&] { return title().find("Esc stops it") != std::string::npos; });
  };
  const std::string line = "gl.Enable(gl.DEPTH_TEST)";
  edit(line, "while true do end");
  EXPECT_TRUE(draws_on());
  edit("while true do end", line);
  const image::Image expected = picture();
  EXPECT_TRUE(soon([&] { return title() == "mine.lua - shadowlab"; })) << title();
  EXPECT_TRUE(soon([&] { return shows(expected); }));
  edit(line, "while true do end");
  EXPECT_TRUE(draws_on());
  press("Escape");
  EXPECT_TRUE(soon([&] { return title() == "mine.lua - error - shadowlab"; })) << title();
  EXPECT_TRUE(soon([&] { return shows(expected); })) << "the last good picture stands";
  press("F5");
  EXPECT_TRUE(draws_on());
  press("ctrl+q");
  EXPECT_EQ(ended(), 0) << said();
}

TEST_F(Person, steps_through_the_passes_by_the_arrows) {
  copy_recipe();
  EXPECT_EQ(run(std::string("run mine.lua --captures passes -o all.png") + options), 0);
  open(std::string("mine.lua") + options);
  show_alone();
  ASSERT_TRUE(soon([&] { return shows(image::read_png(folder / "all.png")); }));
  std::vector<fs::path> passes;
  for (const auto& entry : fs::directory_iterator(folder / "passes"))
    if (entry.path().string().ends_with(".color.png")) passes.push_back(entry.path());
  std::sort(passes.begin(), passes.end());
  ASSERT_EQ(passes.size(), 4u);
  for (const char* const begin : {" - 1. ", " - 2. ", " - 3. "}) {
    press("Down");
    EXPECT_TRUE(soon([&] { return title().find(begin) != std::string::npos; })) << title();
  }
  EXPECT_TRUE(soon([&] { return shows(image::read_png(passes[2])); }));
  press("Up Up");
  EXPECT_TRUE(soon([&] { return shows(image::read_png(passes[0])); }));
  press("Home");
  EXPECT_TRUE(soon([&] { return shows(image::read_png(folder / "all.png")); }));
  press("Escape");
  EXPECT_EQ(ended(), 0) << said();
}

TEST_F(Person, presses_the_recipes_key_and_changes_a_parameter) {
  copy_recipe();
  open(std::string("mine.lua") + options);
  show_alone();
  const auto expect = [&](const image::Image& expected) {
    EXPECT_TRUE(soon([&] { return shows(expected); }));
  };
  press("s");
  expect(picture("--set darkness=0"));
  press("Right Right");  // two fortieths of its range
  expect(picture("--set darkness=0.05"));
  press("ctrl+r");
  expect(picture());
  press("ctrl+s");
  EXPECT_TRUE(soon([&] { return fs::exists(folder / "mine.png"); }));
  EXPECT_EQ(image::read_png(folder / "mine.png"), picture());
  press("Escape");
  EXPECT_EQ(ended(), 0) << said();
}

// As after a context that was lost, which no software driver does on its own.
TEST_F(Person, gets_another_window_with_everything_as_it_was) {
  copy_recipe();
  write("mine.lua", "print \"loaded\"\n" + recipe());
  const image::Image expected = picture("--set darkness=0");
  open(std::string("mine.lua") + options);
  const auto loaded = [&](std::size_t times) {
    return soon([&] {
      const std::string text = said();
      std::size_t count = 0;
      for (auto at = text.find("loaded"); at != std::string::npos; at = text.find("loaded", at + 1))
        ++count;
      return count == times;
    });
  };
  EXPECT_TRUE(loaded(2)) << "by run, and by the window";
  show_alone();
  press("s");
  EXPECT_TRUE(soon([&] { return shows(expected); }));
  press("Down Down");
  EXPECT_TRUE(soon([&] { return title().find(" - 2. ") != std::string::npos; }));
  press("ctrl+F5");
  EXPECT_TRUE(loaded(3));
  EXPECT_TRUE(soon([&] { return title().find(" - 2. ") != std::string::npos; })) << title();
  press("Home");
  EXPECT_TRUE(soon([&] { return shows(expected); }));
  press("Escape");
  EXPECT_EQ(ended(), 0) << said();
}

// The light is where the camera looks, so in the picture's middle.
TEST_F(Person, drags_the_light) {
  fs::create_directory(folder / "scenes");
  write("scenes/bare.lua",
        "return { title = \"bare\", camera = { eye = vec3(0, 0, 4), target = vec3(0, 0, 0) },\n"
        "  objects = { { name = \"floor\", role = \"receiver\", mesh = mesh.plane(1, 1),\n"
        "                model = mat4.translate(0, -9, 0) } } }\n");
  write("mine.lua",
        "local recipe = { scene = \"bare\", params = { light = param.point(0, 0, 0) } }\n"
        "local last\nfunction recipe.draw(r)\n  local l = r.params.light\n"
        "  local text = string.format(\"light %.2f %.2f %.2f\", l.x, l.y, l.z)\n"
        "  if text ~= last then print(text) end\n  last = text\nend\nreturn recipe\n");
  open(std::string("mine.lua") + options);
  ASSERT_TRUE(soon([&] { return said().find("light 0.00 0.00 0.00") != std::string::npos; }));
  press("ctrl+1");
  // The middle between the panels; the light's mark is the one bright thing on the black picture.
  int x = 0, y = 0;
  ASSERT_TRUE(soon([&] {
    const image::Image all = screen();
    for (y = 100; y < height - 100; ++y) {
      for (x = 350; x < width - 450; ++x) {
        if (all.at(x, y) == std::array<std::uint8_t, 4>{255, 235, 150, 255}) return true;
      }
    }
    return false;
  }));
  const auto at = [](int to_x, int to_y) {
    return "mousemove " + std::to_string(to_x) + " " + std::to_string(to_y);
  };
  mouse(at(x, y + 2));
  mouse("mousedown 1");
  for (int step = 1; step <= 6; ++step) mouse(at(x + 5 * step, y + 2 - 5 * step));
  mouse("mouseup 1");
  // To the right and up, and no nearer.
  const std::regex moved("light 0\\.[1-9]\\d 0\\.[1-9]\\d -?0\\.00");
  EXPECT_TRUE(soon([&] { return std::regex_search(said(), moved); })) << said();
  press("ctrl+Left");
  press("Escape");
  EXPECT_EQ(ended(), 0) << said();
}

TEST_F(Person, unplugs_the_monitor_of_a_full_screen_and_plugs_it_in_again) {
  if (!installed("xrandr")) GTEST_SKIP() << "needs xrandr (packages.txt)";
  copy_recipe();
  open(std::string("mine.lua") + options);
  show_alone();
  const image::Image expected = picture();
  press("F11");
  EXPECT_TRUE(soon([&] { return shows(expected); }));
  plug("--off");
  EXPECT_TRUE(soon([&] { return !shows(expected); })) << "nothing is seen without a monitor";
  EXPECT_TRUE(runs()) << said();
  plug("--auto");
  EXPECT_TRUE(soon([&] { return shows(expected); }));
  const image::Image changed = picture("--set darkness=0");
  press("s");
  EXPECT_TRUE(soon([&] { return shows(changed); }));
  press("Escape");
  EXPECT_EQ(ended(), 0) << said();
}

TEST_F(Person, may_do_anything_to_the_window) {
  copy_recipe();
  open(std::string("mine.lua projected_plain") + options);
  press("F1 F3 F3 F3 F4 F4 F4 F6 F6 F6 F6 F6 F7 F8 F12 F12 Tab Left space ctrl+space F11 F11");
  press("shift+Left ctrl+Up alt+Left Prior Next ctrl+Tab F2 F2 F8 F1 F5");
  mouse("mousemove 600 400 click 4 click 5 click 3 mousemove 100 300 click 1");
  EXPECT_TRUE(runs()) << said();
  for (const char* const size : {"1 1", "40 700", "1280 800"}) {
    mouse(std::string("search --onlyvisible --name shadowlab windowsize --sync ") + size);
    press("F5");
    EXPECT_TRUE(runs()) << size << said();
  }
  press("Escape");
  EXPECT_EQ(ended(), 0) << said();
}

}  // namespace
}  // namespace shadowlab::live_tests
