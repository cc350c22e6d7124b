// What the live window costs, without a window: the same panels into the framebuffer of an OSMesa
// context of 1280x800.
//
//   bench_live [latency|share|memory]
//
// Prints the time from saving a recipe to its new picture, while the files are looked at 60 times a
// second (target 100 ms); the interface's share of a frame (target 10 %), frames with and without
// it interleaved in one run; and the memory that reloads leave behind (target: none).
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <thread>

#include "core/version.h"
#include "live/panels.h"
#include "measure/median.h"

namespace shadowlab::live {
namespace {

namespace fs = std::filesystem;

constexpr int width = 1280, height = 800, picture = 512;

double now_ms() {
  using namespace std::chrono;
  return duration<double, std::milli>(steady_clock::now().time_since_epoch()).count();
}

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// The window's loop but for the window.
class Session {
 public:
  explicit Session(const fs::path& file)
      : graphics_(context::create(context::Backend::osmesa, {width, height}), picture, picture),
        screen_(graphics_),
        interface_(graphics_),
        studio_(graphics_, {{file}, {}, options()}) {}

  void draw_interface() {
    interface_.set_style(Style::desk, 1);
    interface_.begin({width, height}, 1.0 / 60);
    draw_window(studio_, view_, interface_);
    screen_.begin(width, height, {0, 0, 0});
    interface_.end(screen_);
    graphics_.gl.Finish.unrecorded();
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

void print_share(const std::string& recipe) {
  const Copy copy(recipe);
  Session session(copy.file());
  std::vector<double> frames, interfaces;
  for (int i = 0; i < 60; ++i) {
    double began = now_ms();
    session.studio().touch();
    session.studio().step(1.0 / 60);
    session.studio().graphics().gl.Finish.unrecorded();
    const double drawn = now_ms();
    session.draw_interface();
    if (i < 10) continue;  // shaders are compiled
    frames.push_back(drawn - began);
    interfaces.push_back(now_ms() - drawn);
  }
  const double frame = measure::median(frames), interface = measure::median(interfaces);
  fmt::print("{:<20}  {:>8.2f}  {:>9.2f}  {:>5.1f} %\n", recipe, frame, interface,
             100 * interface / (frame + interface));
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

int main(int argc, char** argv) {
  using namespace shadowlab::live;
  const auto wanted = [&](std::string_view part) { return argc < 2 || part == argv[1]; };
  if (wanted("latency")) {
    fmt::print("from saving to the picture, ms\n{:<20}  {:>8}  {:>8}\n", "recipe", "median",
               "most");
    for (const char* recipe : {"projected_stencil", "volumes_zfail", "shadow_map_fbo"})
      print_latency(recipe);
  }
  if (wanted("share")) {
    fmt::print("a frame of {}x{} in a window of {}x{}, ms\n{:<20}  {:>8}  {:>9}  {:>7}\n", picture,
               picture, width, height, "recipe", "recipe", "interface", "share");
    for (const char* recipe : {"projected_stencil", "volumes_zfail", "shadow_map_fbo", "room"})
      print_share(recipe);
  }
  if (wanted("memory")) {
    fmt::print("resident memory after so many reloads, MB\n{:<20}  {:>8}  {:>8}\n", "recipe", "100",
               "1000");
    print_memory("projected_stencil");
  }
}
