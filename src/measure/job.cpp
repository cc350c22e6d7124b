#include "measure/job.h"

#include <fmt/format.h>

#include <algorithm>

namespace shadowlab::measure {
namespace {

using Settings = std::vector<std::pair<std::string, std::string>>;

std::vector<Settings> every_combination(const std::vector<recipe::Swept>& sweep) {
  std::vector<Settings> all{{}};
  for (const recipe::Swept& swept : sweep) {
    std::vector<Settings> longer;
    for (const Settings& settings : all) {
      for (const std::string& value : swept.values) {
        longer.push_back(settings);
        longer.back().emplace_back(swept.name, value);
      }
    }
    all = std::move(longer);
  }
  return all;
}

std::vector<Settings> first_ones(const std::vector<recipe::Swept>& sweep) {
  std::vector<Settings> all;
  for (const recipe::Swept& swept : sweep) {
    for (std::size_t i = 0; i < std::min<std::size_t>(3, swept.values.size()); ++i)
      all.push_back({{swept.name, swept.values[i]}});
  }
  return all;
}

}  // namespace

std::string Job::name() const {
  std::string name = fmt::format("{}/{}", scene, recipe.stem().string());
  for (const auto& [parameter, value] : settings) name += fmt::format(" {}={}", parameter, value);
  if (planned()) name += " planned";
  return name;
}

std::vector<Job> jobs_of(gl::Graphics& graphics, const std::filesystem::path& recipe,
                         const std::string& scene, Extent extent) {
  recipe::Options options;
  options.scene = scene;
  const recipe::Recipe read(graphics, recipe, std::move(options));
  claim_of(read, recipe);
  const auto& sweep = read.description().sweep;
  std::vector<Job> jobs;
  if (!sweep.empty()) {
    for (Settings& settings : extent == Extent::full ? every_combination(sweep) : first_ones(sweep))
      jobs.push_back({recipe, scene, std::move(settings)});
  }
  jobs.push_back({recipe, scene, {}});
  jobs.push_back({recipe, scene, {}, recipe::Options::Casters::planned});
  return jobs;
}

std::unique_ptr<recipe::Recipe> recipe_of(gl::Graphics& graphics, const Job& job, double radius,
                                          recipe::Options::Shading shading) {
  recipe::Options options;
  options.scene = job.scene;
  options.casters = job.casters;
  options.shading = shading;
  auto made = std::make_unique<recipe::Recipe>(graphics, job.recipe, std::move(options));
  for (const auto& [name, value] : job.settings) made->set(name, value);
  if (claim_of(*made, job.recipe).soft()) made->set("radius", fmt::format("{}", radius));
  return made;
}

}  // namespace shadowlab::measure
