// What the live window costs: in a window of 1280x800 where there is a display, else into the
// framebuffer of an OSMesa context of that size.
//
//   bench_live [latency|share|memory]
//
// Prints the time from saving a recipe to its new picture, while the files are looked at 60 times a
// second (target 100 ms); the interface's share of a frame (target 10 %); and the memory that
// reloads leave behind (target: none).
//
// A frame is the recipe's, the picture, the interface around and over it and, in a window, its way
// to the screen. A window that shows the picture in the same place and nothing else needs all but
// the interface, and a pass that is looked at costs what the frame takes longer by: each is drawn
// in turns with what has it, and the differences count. What is compared are means over the quarter
// of a second after which the panels' times are others, and of those the median.
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <thread>

#include "core/clock.h"
#include "core/version.h"
#include "live/panels.h"
#include "measure/median.h"

namespace shadowlab::live {
namespace {

namespace fs = std::filesystem;

constexpr int width = 1280, height = 800, picture = 512;

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

context::Context window_or_none() {
  if (std::getenv("DISPLAY")) return context::create_window({"shadowlab", {width, height}});
  return context::create(context::Backend::osmesa, {width, height});
}

// The window's loop.
class Session {
 public:
  explicit Session(const fs::path& file)
      : graphics_(window_or_none(), picture, picture),
        screen_(graphics_),
        interface_(graphics_),
        studio_(graphics_, {{file}, {}, options()}) {
    if (context::Window* const window = graphics_.context().window()) {
      window->events(0.1);  // it is given its place on the screen
      size_ = window->size();
    }
  }

  void draw_interface() {
    interface_.set_style(Style::desk, 1);
    interface_.begin(size_, 1.0 / 60);
    draw_window(studio_, view_, interface_);
    screen_.begin(size_.width, size_.height, {0, 0, 0});
    interface_.end(screen_);
    graphics_.gl.Finish.unrecorded();
  }

  /// The picture where the interface has it, alone.
  void draw_picture() {
    const Rectangle at = view_.picture.placed();
    const auto left = static_cast<float>(at.x), top = static_cast<float>(at.y);
    const auto right = static_cast<float>(at.x + at.width);
    const auto bottom = static_cast<float>(at.y + at.height);
    constexpr std::uint32_t white = 0xFFFFFFFF;
    const std::array<gl::ScreenVertex, 4> corners{{{left, top, 0, 1, white},
                                                   {right, top, 1, 1, white},
                                                   {right, bottom, 1, 0, white},
                                                   {left, bottom, 0, 0, white}}};
    constexpr std::array<std::uint16_t, 6> indices{0, 1, 2, 0, 2, 3};
    // On a ground that is there already.
    const gl::ScreenBatch batch{studio_.shown(studio_.bench()).texture(),
                                gl::ScreenBatch::Alpha::ignored,
                                {left, top, right, bottom},
                                0,
                                indices.size()};
    screen_.begin(size_.width, size_.height, {0, 0, 0});
    screen_.draw({corners, indices, {&batch, 1}});
    graphics_.gl.Finish.unrecorded();
  }

  void present() {
    if (context::Window* const window = graphics_.context().window()) {
      window->swap();
      graphics_.gl.Finish.unrecorded();
      window->events(0);
    }
  }

  Studio& studio() { return studio_; }

 private:
  static recipe::Options options() {
    recipe::Options options;
    options.time_passes = true;
    return options;
  }
  gl::Graphics graphics_;
  gl::Screen screen_;
  Interface interface_;
  Studio studio_;
  View view_;
  context::Size size_{width, height};
};

// A copy of the recipe, to be edited.
class Copy {
 public:
  explicit Copy(const std::string& recipe)
      : folder_(fs::temp_directory_path() / fmt::format("shadowlab-bench-live-{}", ::getpid())) {
    fs::create_directory(folder_);
    text_ = text_of(home() / "scripts" / (recipe + ".lua"));
    save(0);
  }
  ~Copy() { fs::remove_all(folder_); }
  fs::path file() const { return folder_ / "copy.lua"; }
  void save(int edit) const {
    std::ofstream(file(), std::ios::binary) << text_ << "-- " << edit << "\n";
  }

 private:
  fs::path folder_;
  std::string text_;
};

void print_latency(const std::string& recipe) {
  const Copy copy(recipe);
  Session session(copy.file());
  session.studio().step(1.0 / 60);
  std::vector<double> times;
  for (int edit = 1; edit <= 40; ++edit) {
    // At any moment of the window's frame.
    std::this_thread::sleep_for(std::chrono::milliseconds(edit * 7 % 16));
    const int before = session.studio().bench().workshop.versions();
    const double saved = now_ms();
    copy.save(edit);
    double frame = saved;
    while (session.studio().bench().workshop.versions() == before) {
      session.studio().step(0);
      session.draw_interface();
      frame += 1000.0 / 60;
      const double left = frame - now_ms();
      if (left > 0) std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(left));
    }
    times.push_back(now_ms() - saved);
  }
  fmt::print("{:<20}  {:>8.1f}  {:>8.1f}\n", recipe, measure::median(times),
             *std::max_element(times.begin(), times.end()));
}

double milliseconds_of(const std::function<void()>& work) {
  const double began = now_ms();
  work();
  return now_ms() - began;
}

// Milliseconds of a frame's parts.
struct Parts {
  double recipe = 0, looking = 0, whole = 0, bare = 0, present = 0;
  double interface() const { return looking + whole - bare; }
  /// Of the frame, the interface.
  double share() const { return interface() / (recipe + looking + whole + present); }
};

// Means over a quarter of a second.
Parts quarter(Session& session, const std::optional<PassName>& pass) {
  constexpr int frames = 15;
  Studio& studio = session.studio();
  const auto recipe_of = [&](const std::optional<PassName>& looked_at) {
    return milliseconds_of([&] {
             studio.choose_pass(looked_at);
             studio.step(1.0 / 60);
             studio.graphics().gl.Finish.unrecorded();
           }) /
           frames;
  };
  Parts parts;
  const auto plain = [&] { parts.recipe += recipe_of({}); };
  const auto looked_at = [&] { parts.looking += pass ? recipe_of(pass) : 0; };
  const auto bare = [&] {
    parts.bare += milliseconds_of([&] { session.draw_picture(); }) / frames;
    session.present();
  };
  const auto whole = [&] {
    parts.whole += milliseconds_of([&] { session.draw_interface(); }) / frames;
    parts.present += milliseconds_of([&] { session.present(); }) / frames;
  };
  // The first of two finds the caches colder.
  for (int i = 0; i < frames; ++i) {
    i % 2 == 0 ? (plain(), looked_at()) : (looked_at(), plain());
    if (i % 2 == 1 && pass) recipe_of(pass);  // the window shows the pass in any case
    i % 4 < 2 ? (bare(), whole()) : (whole(), bare());
  }
  if (pass) parts.looking -= parts.recipe;
  return parts;
}

void print_share(const std::string& recipe, const char* looking) {
  const Copy copy(recipe);
  Session session(copy.file());
  session.studio().step(0);
  std::optional<PassName> pass;
  if (std::string_view(looking) == "a pass") pass = session.studio().inspector().passes()[0].name;
  std::vector<Parts> quarters;
  session.draw_interface();  // shaders are compiled
  quarter(session, pass);
  const std::size_t count = recipe == "room" ? 3 : 15;  // it takes a quarter of a second a frame
  quarters.reserve(count);
  while (quarters.size() < count) quarters.push_back(quarter(session, pass));
  const auto median = [&](const auto& of) {
    std::vector<double> values;
    values.reserve(quarters.size());
    for (const Parts& parts : quarters) values.push_back(of(parts));
    return measure::median(values);
  };
  fmt::print("{:<20}  {:<8}  {:>8.2f}  {:>8.2f}  {:>8.2f}  {:>8.2f}  {:>9.2f}  {:>5.1f} %\n",
             recipe, looking, median([](const Parts& p) { return p.recipe; }),
             median([](const Parts& p) { return p.bare; }),
             median([](const Parts& p) { return p.present; }),
             median([](const Parts& p) { return p.looking; }),
             median([](const Parts& p) { return p.whole - p.bare; }),
             100 * median([](const Parts& p) { return p.share(); }));
}

double resident_mb() {
  std::ifstream statm("/proc/self/statm");
  long all = 0, resident = 0;
  statm >> all >> resident;
  return static_cast<double>(resident * ::sysconf(_SC_PAGESIZE)) / (1 << 20);
}

void print_memory(const std::string& recipe) {
  const Copy copy(recipe);
  Session session(copy.file());
  double after_100 = 0;
  for (int i = 0; i < 1000; ++i) {
    session.studio().reload_all();
    session.studio().step(1.0 / 60);
    session.draw_interface();
    if (i == 99) after_100 = resident_mb();
  }
  fmt::print("{:<20}  {:>8.1f}  {:>8.1f}\n", recipe, after_100, resident_mb());
}

}  // namespace
}  // namespace shadowlab::live

int main(int argc, char** argv) try {
  using namespace shadowlab::live;
  const auto wanted = [&](std::string_view part) { return argc < 2 || part == argv[1]; };
  if (wanted("latency")) {
    fmt::print("from saving to the picture, ms\n{:<20}  {:>8}  {:>8}\n", "recipe", "median",
               "most");
    for (const char* recipe : {"projected_stencil", "volumes_zfail", "shadow_map_fbo"})
      print_latency(recipe);
  }
  if (wanted("share")) {
    fmt::print(
        "a frame of {}x{} in a window of {}x{}{}, ms\n{:<20}  {:<8}  {:>8}  {:>8}  {:>8}  {:>8}  "
        "{:>9}  {:>7}\n",
        picture, picture, width, height, std::getenv("DISPLAY") ? "" : " that is not shown",
        "recipe", "look at", "recipe", "picture", "present", "looking", "panels", "share");
    for (const char* recipe : {"projected_stencil", "volumes_zfail", "shadow_map_fbo", "room"})
      print_share(recipe, "frame");
    print_share("projected_stencil", "a pass");
  }
  if (wanted("memory")) {
    fmt::print("resident memory after so many reloads, MB\n{:<20}  {:>8}  {:>8}\n", "recipe", "100",
               "1000");
    print_memory("projected_stencil");
  }
} catch (const std::exception& problem) {
  fmt::print(stderr, "bench_live: {}\n", problem.what());
  return 3;
}
