// A recipe while it is being written: the version that runs, and the one on the disk.
//
// A version takes over only when a whole frame of it succeeded. Until then, and when a later frame
// fails, the last good one keeps its picture, and `failure` says what is wrong. What the user set
// (parameters, moved objects) goes from version to version.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "live/failure.h"
#include "live/watcher.h"
#include "recipe/recipe.h"

namespace shadowlab::live {

/// What a frame is drawn with.
struct Moment {
  double time = 0;                      ///< seconds
  std::optional<scene::Camera> camera;  ///< the scene's own unless given
};

/// What a user changed of a recipe, which every version of it takes over.
struct Changes {
  std::map<std::string, std::string> settings;  ///< parameters
  std::map<std::string, glm::dmat4> models;     ///< objects that were moved
};

class Workshop {
 public:
  /// `options` are every version's. Draws nothing. While a script runs the files are looked at too:
  /// one that is saved stops the version that it replaces, and an endless one no longer matters.
  Workshop(gl::Graphics& graphics, std::filesystem::path file, recipe::Options options);
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;

  const std::filesystem::path& file() const { return file_; }

  /// Looks at the files; whether they ask for another version, which `draw` then tries.
  bool look();
  /// The next frame is tried with the version on the disk, changed or not.
  void reload() { wanted_ = true; }
  /// Whether it is.
  bool tries_next() const { return wanted_; }

  enum class Drawn {
    picture,  ///< the main frame holds a whole frame
    nothing,  ///< it failed, or nothing changed since it did: the last picture stands
  };
  /// A frame of the version on the disk where another is asked for, else of the one that runs. No
  /// error leaves it.
  Drawn draw(const Moment& moment);

  /// The version that runs, at `1 / coarseness` of the picture's size: for a hand that moves
  /// something faster than frames are drawn. The main frame has that size afterwards, until
  /// `Graphics::resize`. It is set up for that size by itself, so it draws as the recipe would.
  Drawn draw_coarse(const Moment& moment, int coarseness);

  /// The version that runs; null before the first good one. It is replaced by draw alone.
  recipe::Recipe* recipe() const { return good_.get(); }
  /// How many versions took over.
  int versions() const { return versions_; }
  const std::optional<Failure>& failure() const { return failure_; }

  /// Sets a parameter of this version and those that follow. Throws InputError where it does not
  /// fit.
  void set(const std::string& name, const std::string& value);
  /// Forgets what was set: the parameters are the recipe's own again.
  void reset_parameters();
  const Changes& changes() const { return changes_; }
  /// Before the first version: those of another session with the recipe.
  void take_over(Changes changes) { changes_ = std::move(changes); }
  /// Moves an object of the scene, in this version and those that follow.
  void move(const std::string& object, const glm::dmat4& model);
  /// A failed frame is tried again: its cause may be gone.
  void retry() { failed_here_ = false; }

  /// Called for every version before its first frame: where to listen to its passes.
  void on_version(std::function<void(recipe::Recipe&)> listener) {
    listener_ = std::move(listener);
  }

 private:
  bool is_superseded();
  Drawn draw_candidate(const Moment& moment);
  void carry_over(recipe::Recipe& recipe) const;

  gl::Graphics& graphics_;
  std::filesystem::path file_;
  recipe::Options options_;
  Watcher watcher_;
  std::set<std::filesystem::path> files_;  ///< that the versions asked for since the last good one
  std::unique_ptr<recipe::Recipe> good_;
  std::unique_ptr<recipe::Recipe> coarse_;  ///< the same version, set up for a smaller picture
  int coarseness_ = 0;                      ///< of `coarse_`
  std::optional<Failure> failure_;
  Changes changes_;
  std::function<void(recipe::Recipe&)> listener_;
  bool wanted_ = true;
  bool superseded_ = false;      ///< a file was saved while the version that it replaces was drawn
  bool failed_here_ = false;     ///< the version that runs failed, and nothing changed since
  bool failure_is_its_ = false;  ///< `failure_` is of the version that runs, not of a newer one
  bool frame_broken_ = false;    ///< the main frame holds what a failure left in it
  int versions_ = 0;
};

}  // namespace shadowlab::live
