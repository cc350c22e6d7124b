// A lab: what lab.lua says, and the files beside it.
//
//   labs/06_projected_stencil/
//     lab.lua            the manifest: title, points, size, cases
//     template.lua       what a student begins with; "-- floor: 20" is the percent it may score
//     solution.lua       the reference
//     mistakes/*.lua     wrong recipes, each with its hint in comment lines at its top
//     alternatives/*.lua recipes that are right in another way: for tests
//     README.md          the exercise
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "lab/job.h"

namespace shadowlab::lab {

/// What of a case is held against the reference, beside that it draws at all.
struct Compared {
  bool color = true;                   ///< the frame's colour at its end
  std::optional<std::string> stencil;  ///< the stencil after the pass of that name
  std::optional<std::string> depth;    ///< likewise
};

struct Case {
  std::string name;
  double points = 0;
  bool hidden = false;  ///< from students: neither its settings nor its pictures are told
  Compared compared;
  Shot shot;
};

/// A wrong recipe and what to say to whom has made the same mistake.
struct Mistake {
  std::string name;  ///< the file's, without its ending
  std::filesystem::path file;
  std::map<std::string, std::string> hints;  ///< by language: "en", "ca", "es", "fr"
};

struct Lab {
  std::string name;  ///< the folder's: "06_projected_stencil"
  std::filesystem::path folder;
  std::string title;
  double points = 0;
  int width = 256, height = 256;
  std::vector<Case> cases;
  double floor = 0;  ///< percent that the template may score
  std::vector<Mistake> mistakes;
  std::vector<std::filesystem::path> alternatives;
  /// Of the lab's own files, so that results of one lab are not mixed with those of another.
  std::uint64_t digest = 0;
  /// What random.* drew from: the same seed gives the same cases, on every machine.
  std::uint64_t seed = 0;

  std::filesystem::path solution() const { return folder / "solution.lua"; }
  std::filesystem::path start() const { return folder / "template.lua"; }
};

/// Reads the lab in `folder`. Its random cases are drawn from `seed` and the lab's name; without a
/// seed, from the digest of its files, which nobody knows who has not got them. Throws InputError
/// for a manifest that is missing or wrong: file, line, what is expected.
Lab load_lab(const std::filesystem::path& folder, std::optional<std::uint64_t> seed = {});

}  // namespace shadowlab::lab
