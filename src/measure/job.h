// What is measured: a recipe with some parameters in a scene.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "measure/claim.h"
#include "recipe/recipe.h"

namespace shadowlab::measure {

struct Job {
  std::filesystem::path recipe;
  std::string scene;
  std::vector<std::pair<std::string, std::string>> settings;  ///< swept ones, by name
  recipe::Options::Casters casters = recipe::Options::Casters::all;

  bool planned() const { return casters == recipe::Options::Casters::planned; }
  /// "city/shadow_map_fbo size=256", "city/volumes_zfail planned": no two jobs have the same.
  std::string name() const;
};

/// How much of a sweep is taken.
enum class Extent {
  full,   ///< every value with every other
  coarse  ///< of each list the first three values, the other parameters' own
};

/// The jobs of one recipe in one scene: its sweep, and itself with its own parameters where all
/// casters are drawn and where those of shadow::plan are. Throws InputError for a recipe that is
/// wrong, or that is not held against a truth.
std::vector<Job> jobs_of(gl::Graphics& graphics, const std::filesystem::path& recipe,
                         const std::string& scene, Extent extent);

/// The recipe of a job, as it is to be drawn. Every soft one gets the light of `radius`, so that
/// all are held against one truth.
std::unique_ptr<recipe::Recipe> recipe_of(gl::Graphics& graphics, const Job& job, double radius,
                                          recipe::Options::Shading shading);

}  // namespace shadowlab::measure
