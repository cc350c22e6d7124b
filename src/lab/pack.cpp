#include "lab/pack.h"

#include <fmt/format.h>
#include <unistd.h>
#include <cstdlib>

#include <algorithm>
#include <array>

#include "core/error.h"
#include "image/image.h"
#include "lab/text_file.h"

namespace shadowlab::lab {
namespace {

namespace fs = std::filesystem;

// What a grader runs with is what packages.txt lists apart from its parts on building and tests:
// the packages to build against bring the libraries to run with, by whatever name they have.
constexpr std::string_view setup = R"sh(#!/usr/bin/env bash
# Gradescope runs this once, when it makes the image of the autograder.
set -euo pipefail
source=${AUTOGRADER_ROOT:-/autograder}/source
export DEBIAN_FRONTEND=noninteractive
install_parts() { # the parts of packages.txt whose first line AWK says
  awk '/^#/ { part = $0 } !/^#/ && ('"$1"')' "$source/packages.txt" |
    xargs -r apt-get install -y --no-install-recommends
}
apt-get update
install_parts 'part !~ /^# (build|tests)$/'
if ! "$source/bin/shadowlab" --version; then
  echo "This image is not Debian 12: shadowlab is built here."
  install_parts 'part == "# build"'
  cmake -S "$source" -B /tmp/build -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DSHADOWLAB_TESTS=OFF -DSHADOWLAB_BENCH=OFF
  cmake --build /tmp/build --target shadowlab
  install /tmp/build/bin/shadowlab "$source/bin/shadowlab"
fi
)sh";

constexpr std::string_view run = R"sh(#!/usr/bin/env bash
# Gradescope runs this for each submission; what counts is results/results.json.
root=${{AUTOGRADER_ROOT:-/autograder}}
export SHADOWLAB_HOME=$root/source
"$root/source/bin/shadowlab" grade "$root/source/labs/{name}" "$root/submission" --one \
  --format gradescope -o "$root/results"
code=$?
# 1 says that marks were lost, which is no fault of the autograder.
[ "$code" -le 1 ]
)sh";

void add_file(std::vector<Packed>& files, const fs::path& file, const std::string& name,
              Packed::Mode mode = Packed::Mode::plain) {
  files.push_back({name, read_text(file), mode});
}

void add_folder(std::vector<Packed>& files, const fs::path& folder, const std::string& name) {
  std::vector<fs::path> found;
  std::error_code none;
  for (const auto& entry : fs::recursive_directory_iterator(folder, none)) {
    if (entry.is_regular_file() && !entry.path().filename().string().starts_with('.'))
      found.push_back(entry.path());
  }
  std::sort(found.begin(), found.end());
  for (const fs::path& file : found)
    add_file(files, file, name + "/" + file.lexically_relative(folder).generic_string());
}

std::string quoted(const std::string& text) {
  std::string lua = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') lua += '\\';
    lua += c;
  }
  return lua + "\"";
}

std::string three(const glm::dvec3& v) { return fmt::format("{{{}, {}, {}}}", v.x, v.y, v.z); }

// A setting's text as the Lua that gives it.
std::string value(const std::string& text) {
  if (text == "true" || text == "false") return text;
  const bool numbers = !text.empty() && text.find_first_not_of("0123456789.,-+e ") == text.npos;
  if (!numbers) return quoted(text);
  return text.find(',') == std::string::npos ? text : "{" + text + "}";
}

std::string as_lua(const Case& a_case) {
  std::string lua =
      fmt::format("    {{ name = {}, points = {}", quoted(a_case.name), a_case.points);
  if (a_case.shot.scene) lua += fmt::format(", scene = {}", quoted(*a_case.shot.scene));
  if (!a_case.shot.settings.empty()) {
    lua += ",\n      set = {";
    for (const auto& [name, text] : a_case.shot.settings)
      lua += fmt::format(" {} = {},", name, value(text));
    lua += " }";
  }
  if (const auto& camera = a_case.shot.camera) {
    lua += fmt::format(",\n      camera = {{ eye = {}, target = {}, fovy = {} }}",
                       three(camera->eye), three(camera->target), camera->fovy);
  }
  return lua + " },\n";
}

std::string png(image::Image picture) {
  for (std::size_t i = 3; i < picture.rgba.size(); i += 4) picture.rgba[i] = 255;
  std::string name = (fs::temp_directory_path() / "shadowlab-picture-XXXXXX").string();
  const int file = ::mkstemp(name.data());
  if (file < 0) throw MachineError("cannot write a temporary file");
  ::close(file);
  image::write_png(name, picture);
  std::string bytes = read_text(name);
  fs::remove(name);
  return bytes;
}

}  // namespace

std::vector<Packed> pack_for_student(const Lab& lab, const Reference& reference) {
  std::vector<Packed> files;
  const std::string top = lab.name + "/";
  add_file(files, lab.start(), top + "template.lua");
  std::error_code none;
  if (fs::exists(lab.folder / "README.md", none))
    add_file(files, lab.folder / "README.md", top + "README.md");
  std::string manifest = fmt::format(
      "-- The cases that you can try. Others are hidden, with lights and cameras of their own.\n"
      "return {{\n  title = {}, points = {}, size = {{{}, {}}},\n  cases = {{\n",
      quoted(lab.title), lab.points, lab.width, lab.height);
  for (std::size_t i = 0; i < lab.cases.size(); ++i) {
    if (lab.cases[i].hidden) continue;
    manifest += as_lua(lab.cases[i]);
    files.push_back({fmt::format("{}expected/{}. {}.png", top, i + 1, lab.cases[i].name),
                     png(reference.cases[i].drawing().frame.color)});
  }
  files.push_back({top + "lab.lua", manifest + "  },\n}\n"});
  return files;
}

std::vector<Packed> pack_for_gradescope(const Lab& lab, const fs::path& home,
                                        const fs::path& program) {
  std::vector<Packed> files;
  files.push_back({"setup.sh", std::string(setup), Packed::Mode::executable});
  files.push_back(
      {"run_autograder", fmt::format(run, fmt::arg("name", lab.name)), Packed::Mode::executable});
  add_file(files, program, "bin/shadowlab", Packed::Mode::executable);
  for (const char* file : {"CMakeLists.txt", "packages.txt"}) add_file(files, home / file, file);
  for (const char* folder : {"src", "scripts", "shaders"}) add_folder(files, home / folder, folder);
  add_folder(files, lab.folder, "labs/" + lab.name);
  return files;
}

}  // namespace shadowlab::lab
