// A frame of which only what changed is drawn is the frame.
#include <functional>

#include "window_fixture.h"

namespace shadowlab::live {
namespace {

class DamageTest : public WindowTest {
 protected:
  DamageTest() { open({stock("projected_stencil"), stock("projected_plain")}); }

  // What is on it, but for the mark that counts frames.
  static image::Image seen(const gl::Screen& on) {
    image::Image picture = on.read();
    picture.set(0, height - 1, {0, 0, 0, 255});
    return picture;
  }
};

TEST_F(DamageTest, what_is_drawn_again_makes_the_whole_frame) {
  using context::Key;
  const std::function<void()> actions[] = {
      [] {},
      [&] { press(Key::down); },
      [&] { press(Key::f3); },
      [&] { press(Key::right); },
      [&] {
        press(Key::left, {false, true, false});
      },
      [&] { press(Key::f6); },
      [&] { studio->say("a word in the lowest line"); },
      [&] { press(Key::f1); },
      [&] { press(Key::right); },  // the picture changes below the help
      [&] { press(Key::f1); },
      [&] { view.picture.set_zoom(100); },
      [&] { view.picture.fit(); },
      [&] {
        press(Key::tab, {false, true, false});
      },
      [&] {
        interface.take(context::PointerAt{630, 60});
      },
      [&] { press(Key::f2); },
      [&] { press(Key::f2); },
  };
  int place = 0, kept = 0;
  for (const auto& action : actions) {
    frame();
    frame();  // a panel settles in its second
    action();
    frame();
    kept += screen.kept() ? 1 : 0;
    const image::Image after = seen(screen);
    gl::Screen fresh(small);
    show(fresh);
    EXPECT_FALSE(fresh.kept());
    EXPECT_EQ(after, seen(fresh)) << "after action " << place;
    ++place;
  }
  EXPECT_EQ(kept, place) << "a software context keeps its frames";
}

TEST_F(DamageTest, a_panel_that_says_what_it_said_is_not_drawn_again) {
  for (int i = 0; i < 5; ++i) frame();
  // A blot in the left panel stays where nothing is drawn, and goes where everything is.
  say();
  screen.begin(width, height, ground_of(Style::projector));
  ASSERT_FALSE(screen.kept()) << "another ground";
  interface.end(screen);
  say();
  screen.begin(width, height, ground_of(Style::projector));
  ASSERT_TRUE(screen.kept());
  small.gl.ClearColor.unrecorded(1, 0, 0, 1);
  screen.clear({40, 10, 50, 20});
  const std::array<std::uint8_t, 4> red{255, 0, 0, 255};
  interface.end(screen, Pictures::as_they_were);
  EXPECT_EQ(screen.read().at(45, 15), red);
  gl::Screen fresh(small);
  say();
  show(fresh);
  EXPECT_NE(fresh.read().at(45, 15), red);
}

}  // namespace
}  // namespace shadowlab::live
