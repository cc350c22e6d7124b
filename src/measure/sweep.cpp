#include "measure/sweep.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "core/error.h"
#include "core/version.h"
#include "measure/bar_check.h"
#include "measure/ground_truth.h"
#include "measure/journal.h"
#include "measure/machine.h"
#include "measure/measurement.h"

namespace shadowlab::measure {
namespace {

namespace fs = std::filesystem;

// A name of a job or a scene as that of a file.
std::string file_name(const std::string& name) {
  std::string text;
  for (const char c : name) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       c == '=' || c == '.' || c == '-';
    text += plain ? c : '_';
  }
  return text;
}

image::Image picture_of(const image::FloatImage& visibility) {
  image::Image picture(visibility.width, visibility.height);
  for (std::size_t i = 0; i < visibility.values.size(); ++i) {
    const float value = std::clamp(visibility.values[i], 0.0f, 1.0f);
    const auto grey = static_cast<std::uint8_t>(std::lround(255 * value));
    for (std::size_t channel = 0; channel < 3; ++channel) picture.rgba[4 * i + channel] = grey;
  }
  return picture;
}

Json settings_of(const SweepOptions& options, const gl::Graphics& graphics) {
  Json recipes = Json::array();
  for (const fs::path& recipe : options.recipes)
    recipes.push_back(fs::weakly_canonical(recipe).string());
  return {{"recipes", std::move(recipes)},
          {"scenes", options.scenes},
          {"width", graphics.width()},
          {"height", graphics.height()},
          {"extent", options.extent == Extent::full ? "full" : "coarse"},
          {"radius", options.radius},
          {"bar", options.bar},
          {"rounds", options.rounds},
          {"renderer", graphics.context().renderer},
          {"shadowlab", version()}};
}

std::vector<Job> jobs_of_all(gl::Graphics& graphics, const SweepOptions& options) {
  std::vector<Job> jobs;
  for (const std::string& scene : options.scenes) {
    for (const fs::path& recipe : options.recipes) {
      for (Job& job : jobs_of(graphics, recipe, scene, options.extent))
        jobs.push_back(std::move(job));
    }
  }
  return jobs;
}

class Sweep {
 public:
  Sweep(gl::Graphics& graphics, const SweepOptions& options, const fs::path& folder,
        const std::function<void(const Progress&)>& progress)
      : graphics_(graphics),
        options_(options),
        folder_(folder),
        told_(progress),
        jobs_(jobs_of_all(graphics, options)),
        journal_(folder / "journal.jsonl", settings_of(options, graphics)) {
    progress_.all = 2 + steps_of(options_.curves) +
                    jobs_.size() * static_cast<std::size_t>(1 + options_.rounds);
  }

  Json run() {
    fs::create_directories(folder_ / "pictures");
    step("what a layer of pixels costs here");
    const FillLimit limit =
        limit_of(remembered("limit", [&] { return record_of(fill_limit(graphics_)); }));
    step("the truth against closed forms");
    const Json bar_checks = remembered("bar check", [&] {
      Json rows = Json::array();
      for (const BarCheck& row : check_bar(options_.bar, options_.bar_check_size))
        rows.push_back(record_of(row));
      return rows;
    });
    look_at_all();
    time_all();
    Json points = Json::array();
    for (std::size_t i = 0; i < jobs_.size(); ++i)
      points.push_back(point_of(jobs_[i], looks_[i], rounds_[i], limit));
    Json curves = Json::array();
    for (const Curve& curve : swept_curves(points)) curves.push_back(record_of(curve));
    for (const Curve& curve : timed_curves(options_.curves, graphics_.context().backend, journal_,
                                           [this](std::string what) { step(std::move(what)); }))
      curves.push_back(record_of(curve));
    graphics_.context().make_current();
    Json truths = Json::array();
    for (const std::string& scene : options_.scenes) {
      for (const bool soft : {false, true}) {
        if (const auto record = journal_.find(truth_key(scene, soft))) truths.push_back(*record);
      }
    }
    return {{"options", settings_of(options_, graphics_)},
            {"machine", machine_of(graphics_)},
            {"fill_limit", record_of(limit)},
            {"bar_check", bar_checks},
            {"truths", std::move(truths)},
            {"curves", std::move(curves)},
            {"points", std::move(points)}};
  }

 private:
  void step(std::string what) {
    progress_.what = std::move(what);
    if (told_) told_(progress_);
    ++progress_.done;
  }

  template <class Find>
  Json remembered(const std::string& key, const Find& find) {
    if (const auto before = journal_.find(key)) return *before;
    Json found = find();
    journal_.write(key, found);
    return found;
  }

  static std::string truth_key(const std::string& scene, bool soft) {
    return fmt::format("truth {} {}", scene, soft ? "soft" : "hard");
  }

  void look_at_all() {
    std::unique_ptr<GroundTruth> truth;
    std::string scene;
    for (const Job& job : jobs_) {
      step(job.name());
      const std::string key = "look " + job.name();
      if (!journal_.find(key) && scene != job.scene) {
        scene = job.scene;
        truth = std::make_unique<GroundTruth>(graphics_, options_.reference, scene, options_.bar);
      }
      looks_.push_back(look_of(remembered(key, [&] { return look(job, *truth); })));
    }
  }

  // The pictures before the record: what is recorded has its pictures.
  Json look(const Job& job, GroundTruth& truth) {
    LookPictures pictures;
    const Look look = look_at(graphics_, job, truth, options_.radius, pictures);
    if (!look.left_out) {
      const PictureNames names = pictures_of(job.name());
      image::write_png(folder_ / names.visibility, pictures.visibility);
      image::write_png(folder_ / names.error, pictures.error);
      const double radius = look.soft ? options_.radius : 0;
      remembered(truth_key(job.scene, look.soft), [&] {
        const TracedTruth& traced = truth.of(radius);
        image::write_png(folder_ / truth_picture_of(job.scene, look.soft),
                         picture_of(traced.visibility));
        Json record = record_of(traced, radius);
        record["scene"] = job.scene;
        return record;
      });
    }
    return record_of(look);
  }

  void time_all() {
    rounds_.resize(jobs_.size());
    for (int round = 0; round < options_.rounds; ++round) {
      for (std::size_t i = 0; i < jobs_.size(); ++i) {
        step(jobs_[i].name());
        const bool slow = looks_[i].first_frame > options_.slow;
        if (looks_[i].left_out || (slow && round > 0)) continue;
        rounds_[i].push_back(
            round_of(remembered(fmt::format("round {} {}", round, jobs_[i].name()), [&] {
              return record_of(time(graphics_, jobs_[i], options_.radius, options_.milliseconds,
                                    slow ? 1 : options_.most_frames));
            })));
      }
    }
  }

  gl::Graphics& graphics_;
  const SweepOptions& options_;
  fs::path folder_;
  const std::function<void(const Progress&)>& told_;
  std::vector<Job> jobs_;
  Journal journal_;  // after the jobs: what cannot be measured leaves nothing behind
  Progress progress_;
  std::vector<Look> looks_;
  std::vector<std::vector<Round>> rounds_;
};

}  // namespace

Json sweep(gl::Graphics& graphics, const SweepOptions& options, const fs::path& folder,
           const std::function<void(const Progress&)>& progress) {
  return Sweep(graphics, options, folder, progress).run();
}

PictureNames pictures_of(const std::string& point) {
  const std::string stem = "pictures/" + file_name(point);
  return {stem + ".visibility.png", stem + ".error.png"};
}

std::string truth_picture_of(const std::string& scene, bool soft) {
  return fmt::format("pictures/{}.{}.truth.png", file_name(scene), soft ? "soft" : "hard");
}

}  // namespace shadowlab::measure
