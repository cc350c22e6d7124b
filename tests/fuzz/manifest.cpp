// Any text is a lab's manifest whose cases make sense, or an InputError of one line.
#include <cmath>
#include <cstdlib>
#include <fstream>

#include "core/error.h"
#include "in_memory.h"
#include "lab/manifest.h"

namespace {

namespace fs = std::filesystem;

// A lab's folder in memory, with all but its manifest.
class Folder {
 public:
  Folder() {
    std::string name = "/dev/shm/fuzz-XXXXXX";
    path_ = ::mkdtemp(name.data());
    for (const char* file : {"solution.lua", "template.lua"}) write(file, "return {}");
  }
  ~Folder() {
    std::error_code none;
    fs::remove_all(path_, none);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  void write(const char* name, std::string_view text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
  }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

void expect_sense(const shadowlab::lab::Lab& lab) {
  if (lab.width < 1 || lab.height < 1 || lab.cases.empty()) std::abort();
  for (const auto& one : lab.cases) {
    if (!std::isfinite(one.points) || one.points < 0) std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size);
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const Folder folder;
  folder.write("lab.lua", {reinterpret_cast<const char*>(bytes), size});
  try {
    expect_sense(shadowlab::lab::load_lab(folder.path(), 1));
  } catch (const shadowlab::InputError& problem) {
    const std::string_view sentence = problem.what();
    if (sentence.empty() || sentence.find('\n') != std::string_view::npos) std::abort();
  }
  return 0;
}
