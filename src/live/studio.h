// Everything of a live session but its window: the recipes on their benches, one camera, one
// light, one clock, and what the user is looking at.
//
//   Studio studio(graphics, {{"scripts/room.lua"}, {}, {}});
//   studio.step(1.0 / 60);          // looks at the files, draws what has to be drawn
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gl/screen.h"
#include "live/clock.h"
#include "live/dragging.h"
#include "live/film.h"
#include "live/inspector.h"
#include "live/orbit.h"
#include "live/truth_view.h"
#include "live/workshop.h"

namespace shadowlab::live {

/// One recipe and the last picture of it.
struct Bench {
  Bench(gl::Graphics& graphics, const std::filesystem::path& file, const recipe::Options& options)
      : workshop(graphics, file, options), picture(graphics) {}
  Workshop workshop;
  gl::ShownPicture picture;
  double frame_ms = 0;  ///< of the last frame, until GL had finished it
  int version = 0;      ///< of the workshop's versions, the one that was last drawn
  int cold = 0;         ///< frames until its times are those of a warm one
};

struct StudioOptions {
  std::vector<std::filesystem::path> recipes;
  std::vector<std::pair<std::string, std::string>> settings;  ///< parameters, of all recipes
  recipe::Options recipe;
};

class Studio {
 public:
  /// What a user did in a session, without a trace of its context.
  struct Kept {
    std::vector<Changes> changes;  ///< of each recipe
    std::size_t focus = 0;
    Clock clock;
    std::optional<scene::Camera> camera;
    std::optional<PassName> pass;
    LookedAt looked_at;
    TruthMode truth = TruthMode::off;
  };

  Studio(gl::Graphics& graphics, const StudioOptions& options);
  /// The same session in another context: `options` are those of the first.
  Studio(gl::Graphics& graphics, const StudioOptions& options, const Kept& kept);
  Kept kept() const;

  gl::Graphics& graphics() { return graphics_; }
  const std::vector<std::unique_ptr<Bench>>& benches() const { return benches_; }
  /// The one that keys and panels are about.
  Bench& bench() { return *benches_[focus_]; }
  const Bench& bench() const { return *benches_[focus_]; }
  std::size_t focus() const { return focus_; }
  void set_focus(std::size_t index);
  Clock& clock() { return clock_; }

  /// Lets so much time pass, looks at the files and draws what may have become another picture: a
  /// recipe that does not ask for the time stands still until something is changed. Whether there
  /// is anything new to see.
  bool step(double seconds);
  /// Draws again at the next step, whatever the clock says.
  void touch() { touched_ = true; }
  void reload_all();

  // ---- camera, light, objects: of all benches
  /// The scene's camera until it is moved; nothing before there is a scene.
  std::optional<scene::Camera> camera() const;
  void set_camera(const scene::Camera& camera);
  std::optional<glm::dvec4> light() const;
  void set_light(glm::dvec4 light);
  double aspect() const;
  /// Parameters, objects and camera are the recipes' own again.
  void reset();

  enum class Grip { nothing, camera, light, object };
  /// What a hand takes hold of at that place of the picture (-1 to 1, y up); the light from as far
  /// as `reach`, in halves of the picture's height.
  Grip grip_at(glm::dvec2 place, double reach) const;
  /// Takes hold of it; `drag` moves it until `let_go`.
  Grip grab(glm::dvec2 place, Grip wanted);
  void drag(glm::dvec2 place);
  void let_go() { held_ = {}; }
  /// Moves a caster without a hand: which of them, counted round, and by how much (world).
  void shift_caster(std::size_t which, glm::dvec3 step);

  /// Whether a recipe that takes long is drawn coarsely while a hand moves something, and sharply
  /// once it rests.
  enum class Detail { full, as_it_moves };
  Detail detail() const { return detail_; }
  void set_detail(Detail detail) { detail_ = detail; }

  // ---- parameters
  /// Sets a parameter of the bench in focus; the light of all. Throws InputError.
  void set(const std::string& name, const std::string& value);
  /// What the bench's recipe does on this character; whether it does anything.
  bool press(std::string_view character);

  // ---- looking inside
  const Inspector& inspector() const { return inspector_; }
  const std::optional<PassName>& chosen_pass() const { return chosen_; }
  void choose_pass(std::optional<PassName> pass);
  /// To the pass before or after the chosen one; from the frame's end, after it, to the first.
  void step_pass(int by);
  const LookedAt& looked_at() const { return looked_at_; }
  void look_at(LookedAt what);
  void look_at_next();
  void set_pixel(std::optional<glm::ivec2> pixel);
  const std::optional<glm::ivec2>& pixel() const { return pixel_; }
  enum class Numbers { hidden, shown };
  /// Whether the pixels' numbers are to be there: Inspector::buffers, of the frame's end too.
  void set_numbers(Numbers numbers);
  enum class Tracing { off, on };
  /// Whether the calls of each frame are kept, which takes time.
  void set_tracing(Tracing tracing);
  /// Those of the chosen pass, or of the whole frame, as C; not more than a screen or two can show.
  const std::vector<std::string>& calls() const { return calls_; }
  /// What the middle of the window shows of that bench.
  const gl::ShownPicture& shown(const Bench& bench) const;
  /// Whether the pixel of it, counted from the upper left corner, is nearer to white than to black;
  /// while numbers are shown.
  bool is_light_at(std::size_t pixel) const;

  // ---- truth
  TruthMode truth_mode() const { return truth_mode_; }
  void set_truth_mode(TruthMode mode);
  const TruthView& truth() const { return truth_; }

  // ---- pictures and films
  /// The recipe's next picture goes into a file beside us.
  void ask_for_screenshot() { screenshot_wanted_ = true; }
  void toggle_film(const std::string& ending);
  bool filming() const { return film_.has_value(); }

  /// What last happened that is worth a line.
  const std::string& message() const { return message_; }
  void say(std::string message) { message_ = std::move(message); }

 private:
  struct Held {
    Grip grip = Grip::nothing;
    std::size_t object = 0;
    glm::dvec2 place{0};  ///< where the hand was
    glm::dvec3 point{0};  ///< what it holds, in the world
    glm::dmat4 model{1};  ///< the object's, when it was taken
  };
  void draw(Bench& bench, const Moment& moment);
  bool draw_coarse(Bench& bench, const Moment& moment);
  void share_light(Bench& bench);
  void hand_moves();
  void move(const std::string& object, const glm::dmat4& model);
  void show_buffers();
  void keep_calls();
  void save_screenshot();
  void film(double seconds);
  void update_truth(double seconds, bool changed);
  const scene::Scene* scene() const;

  gl::Graphics& graphics_;
  recipe::Options options_;
  std::vector<std::unique_ptr<Bench>> benches_;
  std::size_t focus_ = 0;
  Clock clock_;
  std::optional<scene::Camera> camera_;
  bool touched_ = true;
  Held held_;

  Inspector inspector_;
  std::optional<PassName> chosen_;
  LookedAt looked_at_;
  std::optional<glm::ivec2> pixel_;
  image::Image buffer_;  ///< as it is shown, where it is not in colour
  gl::ShownPicture buffer_picture_;
  bool buffer_shown_ = false;
  Numbers numbers_ = Numbers::hidden;
  Tracing tracing_ = Tracing::off;
  gl::Recorder recorder_;
  std::vector<std::string> calls_;

  TruthView truth_;
  TruthMode truth_mode_ = TruthMode::off;
  bool truth_stale_ = true;
  double rested_ = 0;  ///< seconds since anything moved

  Detail detail_ = Detail::as_it_moves;
  bool moves_ = false;   ///< a hand does, since it last rested
  bool coarse_ = false;  ///< what is shown is

  bool screenshot_wanted_ = false;
  std::optional<Film> film_;
  image::Image film_picture_;  ///< the last one that was drawn
  double film_time_ = 0;       ///< until the film's next frame is due
  std::string message_;
};

}  // namespace shadowlab::live
