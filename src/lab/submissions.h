// What was handed in: from files, folders and exports to one recipe a student.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace shadowlab::lab {

struct Submission {
  std::string name;              ///< unique in its run; a folder may be called so
  std::filesystem::path file;    ///< the recipe; empty where there is none, or more than one
  std::filesystem::path folder;  ///< whose other files belong to it; empty: the file alone
  std::string problem;           ///< why there is no recipe: one sentence
};

/// In folders, whether each is a class's or one student's.
enum class Folders { of_a_class, of_one };

/// What was given, with each archive among it unpacked into a folder that goes when this does.
class Unpacked {
 public:
  /// Throws InputError for a broken archive, MachineError where there is no room.
  explicit Unpacked(std::span<const std::filesystem::path> given);
  ~Unpacked();
  Unpacked(const Unpacked&) = delete;
  Unpacked& operator=(const Unpacked&) = delete;

  /// An archive's single folder in place of the archive: exports have one at their top.
  const std::vector<std::filesystem::path>& paths() const { return paths_; }

 private:
  std::filesystem::path folder_;
  std::vector<std::filesystem::path> paths_;
};

/// The submissions of these files and folders, sorted by name. A .lua file is a submission. Of a
/// class's folder, each .lua file in it is one, and so is each folder in it, as the exports of
/// Gradescope and Moodle have them. A student's folder is searched for its recipe: its only .lua
/// file, or that which is called as the lab's template, solution, submission or recipe. Symbolic
/// links are never followed. Throws InputError where a path does not exist or nothing is found.
std::vector<Submission> find_submissions(std::span<const std::filesystem::path> given,
                                         Folders folders);

/// A copy of what belongs to a submission, in a folder of its own that goes when this does: so that
/// no submission lies beside another's.
class Staged {
 public:
  /// Copies regular files that recipes can read (Lua, GLSL, OBJ, PNG), 16 MiB in all. Throws
  /// InputError where there is more, or they cannot be read.
  explicit Staged(const Submission& submission);
  ~Staged();
  Staged(const Staged&) = delete;
  Staged& operator=(const Staged&) = delete;

  const std::filesystem::path& recipe() const { return recipe_; }
  /// The other files, relative to the folder.
  const std::vector<std::filesystem::path>& beside() const { return beside_; }
  const std::filesystem::path& folder() const { return folder_; }
  std::uint64_t digest() const { return digest_; }

 private:
  void copy(const std::filesystem::path& from, const std::filesystem::path& to);

  std::filesystem::path folder_, recipe_;
  std::vector<std::filesystem::path> beside_;
  std::uint64_t digest_;
  std::uintmax_t bytes_ = 0;
};

}  // namespace shadowlab::lab
