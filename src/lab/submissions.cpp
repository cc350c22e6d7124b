#include "lab/submissions.h"

#include <fmt/format.h>
#include <cstdlib>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <map>

#include "core/error.h"
#include "lab/digest.h"
#include "lab/zip.h"

namespace shadowlab::lab {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t most_bytes = std::uintmax_t{16} << 20;
constexpr std::array recipe_names{"submission.lua", "template.lua", "recipe.lua", "solution.lua",
                                  "lab.lua"};
constexpr std::array readable{".lua", ".vert", ".frag", ".geom", ".glsl", ".obj", ".png"};

bool regular(const fs::path& path) {
  std::error_code none;
  return fs::is_regular_file(fs::symlink_status(path, none));
}
bool folder(const fs::path& path) {
  std::error_code none;
  return fs::is_directory(fs::symlink_status(path, none));
}
bool is_left_out(const fs::path& path) {
  const std::string name = path.filename().string();
  return name.starts_with('.') || name == "__MACOSX";
}

// What is in a folder, sorted, without links and what systems leave behind.
std::vector<fs::path> entries(const fs::path& path) {
  std::vector<fs::path> found;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(path, none)) {
    if (!is_left_out(entry.path())) found.push_back(entry.path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

// The .lua files of a folder and of those in it.
void collect_recipes(const fs::path& path, int depth, std::vector<fs::path>& found) {
  for (const fs::path& entry : entries(path)) {
    if (regular(entry) && entry.extension() == ".lua") found.push_back(entry);
    if (depth > 0 && folder(entry)) collect_recipes(entry, depth - 1, found);
  }
}

std::string safe(std::string name) {
  for (char& c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < ' ' || c == '/' || c == '\\' || c == ':' || byte == 0x7f) c = '_';
  }
  if (name.empty() || name.starts_with('.')) name.insert(0, "_");
  return name.substr(0, 150);
}

fs::path temporary_folder() {
  std::string name = (fs::temp_directory_path() / "shadowlab-submission-XXXXXX").string();
  if (::mkdtemp(name.data())) return name;
  throw MachineError(fmt::format("cannot make a folder in {}", fs::temp_directory_path().string()));
}

// Whether it is a class's folder: a student's holds the recipe.
bool holds_folders(const fs::path& path) {
  const auto all = entries(path);
  return all.empty() || all.size() > 1 || folder(all[0]);
}

Submission of_folder(const fs::path& path) {
  Submission submission{safe(path.filename().string()), {}, {}, {}};
  std::vector<fs::path> found;
  collect_recipes(path, 2, found);
  if (found.empty()) {
    submission.problem = "there is no .lua file in what was handed in";
    return submission;
  }
  submission.file = found.front();
  if (found.size() > 1) {
    const auto named = [&](const char* name) {
      return std::find_if(found.begin(), found.end(),
                          [&](const fs::path& file) { return file.filename() == name; });
    };
    auto chosen = found.end();
    for (const char* name : recipe_names) {
      if (chosen == found.end()) chosen = named(name);
    }
    if (chosen == found.end()) {
      submission.file.clear();
      submission.problem = fmt::format(
          "there are {} .lua files in what was handed in, and none is called submission.lua",
          found.size());
      return submission;
    }
    submission.file = *chosen;
  }
  submission.folder = submission.file.parent_path();
  return submission;
}

void add(const fs::path& path, Folders folders, std::vector<Submission>& found) {
  if (regular(path)) {
    found.push_back({safe(path.stem().string()), path, {}, {}});
    return;
  }
  if (!folder(path)) {
    std::error_code none;
    throw InputError(fmt::format("{} {}", path.string(),
                                 fs::exists(fs::symlink_status(path, none))
                                     ? "is neither a file nor a folder; links are not followed"
                                     : "does not exist"));
  }
  const fs::path whole = fs::canonical(path);
  if (folders == Folders::of_one) {
    found.push_back(of_folder(whole));
    return;
  }
  for (const fs::path& entry : entries(whole)) {
    if (regular(entry) && entry.extension() == ".lua")
      found.push_back({safe(entry.stem().string()), entry, {}, {}});
    if (folder(entry)) found.push_back(of_folder(entry));
  }
}

// Two of one name become NAME and NAME-2.
void make_unique(std::vector<Submission>& submissions) {
  std::map<std::string, int> taken;
  for (const Submission& one : submissions) taken.emplace(one.name, 0);
  for (Submission& one : submissions) {
    const std::string name = one.name;
    if (++taken[name] == 1) continue;
    do {
      one.name = fmt::format("{}-{}", name, taken[name]);
    } while (taken.contains(one.name) && ++taken[name] > 0);
    taken.emplace(one.name, 1);
  }
}

}  // namespace

std::vector<Submission> find_submissions(std::span<const fs::path> given, Folders folders) {
  std::vector<Submission> found;
  for (const fs::path& path : given) add(path, folders, found);
  if (found.empty())
    throw InputError("there is no submission in what was given: neither .lua files nor folders");
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.name < b.name; });
  make_unique(found);
  return found;
}

Unpacked::Unpacked(std::span<const fs::path> given) {
  for (const fs::path& path : given) {
    if (path.extension() != ".zip" || !regular(path)) {
      paths_.push_back(path);
      continue;
    }
    if (folder_.empty()) folder_ = temporary_folder();
    fs::path to = folder_ / std::to_string(paths_.size()) / path.stem();
    fs::create_directories(to);
    try {
      unzip(path, to);
    } catch (...) {
      std::error_code none;
      fs::remove_all(folder_, none);
      throw;
    }
    const auto top = entries(to);
    paths_.push_back(top.size() == 1 && folder(top[0]) && holds_folders(top[0]) ? top[0] : to);
  }
}

Unpacked::~Unpacked() {
  std::error_code none;
  if (!folder_.empty()) fs::remove_all(folder_, none);
}

Staged::Staged(const Submission& submission)
    : folder_(temporary_folder()), digest_(lab::digest(submission.name)) {
  if (submission.file.empty()) return;
  recipe_ = folder_ / submission.file.filename();
  if (submission.folder.empty()) {
    copy(submission.file, recipe_);
    return;
  }
  std::vector<fs::path> files;
  std::error_code none;
  for (auto at = fs::recursive_directory_iterator(submission.folder, none); at != decltype(at)();
       at.increment(none)) {
    const bool wanted = std::find(readable.begin(), readable.end(),
                                  at->path().extension().string()) != readable.end();
    if (wanted && regular(at->path())) files.push_back(at->path());
    if (at.depth() >= 3) at.disable_recursion_pending();
  }
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) {
    const fs::path to = folder_ / file.lexically_relative(submission.folder);
    fs::create_directories(to.parent_path());
    copy(file, to);
    if (to != recipe_) beside_.push_back(to.lexically_relative(folder_));
  }
}

Staged::~Staged() {
  std::error_code none;
  fs::remove_all(folder_, none);
}

void Staged::copy(const fs::path& from, const fs::path& to) {
  std::error_code none;
  bytes_ += fs::file_size(from, none);
  if (bytes_ > most_bytes) throw InputError("what was handed in has more than 16 MiB");
  std::ifstream in(from, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in) throw InputError(fmt::format("{} cannot be read", from.filename().string()));
  digest_ = lab::digest(text, lab::digest(to.filename().string(), digest_));
  std::ofstream(to, std::ios::binary) << text;
}

}  // namespace shadowlab::lab
