#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <string>
#include <string_view>
#include <unordered_map>

#include "scene/limits.h"
#include "scene/mesh.h"
#include "scene/polygon.h"

namespace shadowlab::scene {

namespace {

constexpr std::uintmax_t max_text = 64u << 20;

/// Cutting ears is cubic; what has more corners than this must be convex.
constexpr std::size_t max_concave_corners = 128;

/// A corner of a face: its position, and its uv and normal or `none`.
struct Corner {
  std::uint32_t position, uv, normal;
  bool operator==(const Corner&) const = default;
};

constexpr std::uint32_t none = 0xffffffffu;

struct CornerHash {
  std::size_t operator()(const Corner& c) const {
    std::uint64_t h = c.position;
    for (const std::uint64_t part : {c.uv, c.normal})
      h = (h ^ (h >> 29) ^ part) * 0x9e3779b97f4a7c15u;
    return static_cast<std::size_t>(h ^ (h >> 32));
  }
};

/// Statements that say nothing about triangles: groups, materials, lines, curves.
constexpr std::array ignored{"g",         "o",      "s",        "mg",       "usemtl", "mtllib",
                             "maplib",    "usemap", "l",        "p",        "vp",     "deg",
                             "bmat",      "step",   "cstype",   "curv",     "curv2",  "surf",
                             "parm",      "trim",   "hole",     "scrv",     "sp",     "end",
                             "con",       "bevel",  "c_interp", "d_interp", "lod",    "shadow_obj",
                             "trace_obj", "ctech",  "stech"};

std::vector<std::string_view> words_of(std::string_view line) {
  constexpr std::string_view blank = " \t\r\v\f";
  line = line.substr(0, line.find('#'));
  std::vector<std::string_view> words;
  for (;;) {
    const std::size_t begin = line.find_first_not_of(blank);
    if (begin == std::string_view::npos) return words;
    line.remove_prefix(begin);
    const std::size_t end = std::min(line.find_first_of(blank), line.size());
    words.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
}

/// The statements of one file, read in order. What is wrong is told by line and never quoted: the
/// file may not be an OBJ at all, and its text nothing that the reader of the message may see.
class ObjReader {
 public:
  explicit ObjReader(std::string name) : name_(std::move(name)) {}

  void read(std::string_view text);
  Mesh mesh() const;

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(fmt::format("{}, line {}: {}.", name_, line_, what));
  }
  void statement(std::string_view line);
  float number(std::string_view word) const;
  std::uint32_t index(std::string_view word, std::size_t count, std::string_view of) const;
  Corner corner(std::string_view word) const;
  void face(std::span<const std::string_view> words);
  bool all_corners_have_normals() const;
  bool all_corners_have_uvs() const;
  std::vector<glm::vec3> smooth_normals() const;

  std::string name_;
  std::size_t line_ = 0;
  std::vector<glm::vec3> positions_;
  std::vector<glm::vec3> normals_;  // of length one, or zero where the file says so
  std::vector<glm::vec2> uvs_;
  std::vector<Corner> corners_;  // three a triangle
};

float ObjReader::number(std::string_view word) const {
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  const bool range = error == std::errc::result_out_of_range;
  if (!range && (error != std::errc() || end != word.data() + word.size())) {
    fail("a coordinate is not a number");
  }
  if (range || !(std::abs(value) <= 1e30)) {
    fail("a coordinate is not finite or beyond 1e30");
  }
  return static_cast<float>(value);
}

/// 1 names the first of `count`, -1 the last so far.
std::uint32_t ObjReader::index(std::string_view word, std::size_t count,
                               std::string_view of) const {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) {
    fail(fmt::format("a face's {} is not a whole number", of));
  }
  const auto last = static_cast<std::int64_t>(count);
  const std::int64_t found = value < 0 ? last + value : value - 1;
  if (value == 0 || found < 0 || found >= last) {
    fail(fmt::format("a face names {} {}, but {} came before it", of, value, count));
  }
  return static_cast<std::uint32_t>(found);
}

/// v, v/vt, v//vn or v/vt/vn.
Corner ObjReader::corner(std::string_view word) const {
  std::array<std::string_view, 3> part;
  std::size_t parts = 0;
  for (;;) {
    const std::size_t slash = word.find('/');
    part[parts++] = word.substr(0, slash);
    if (slash == std::string_view::npos) break;
    if (parts == 3) fail("a face's corner has more than v/vt/vn");
    word.remove_prefix(slash + 1);
  }
  return {index(part[0], positions_.size(), "vertex"),
          part[1].empty() ? none : index(part[1], uvs_.size(), "texture coordinate"),
          part[2].empty() ? none : index(part[2], normals_.size(), "normal")};
}

void ObjReader::face(std::span<const std::string_view> words) {
  if (words.size() < 3) fail(fmt::format("a face has {} corners; it takes 3", words.size()));
  std::vector<Corner> polygon;
  std::vector<glm::dvec3> points;
  for (const std::string_view word : words) {
    polygon.push_back(corner(word));
    points.emplace_back(positions_[polygon.back().position]);
  }
  if (corners_.size() / 3 + polygon.size() - 2 > max_triangles) {
    fail(fmt::format("there are more than {} triangles; simplify the mesh", max_triangles));
  }
  if (polygon.size() > max_concave_corners && !is_convex(points)) {
    fail(fmt::format("a concave face has more than {} corners; cut it", max_concave_corners));
  }
  for (const PolygonTriangle& triangle : triangulate(points)) {
    for (const std::uint32_t i : triangle) corners_.push_back(polygon[i]);
  }
}

void ObjReader::statement(std::string_view line) {
  const std::vector<std::string_view> words = words_of(line);
  if (words.empty()) return;
  const std::span<const std::string_view> rest = std::span(words).subspan(1);
  if (words[0] == "v") {
    if (rest.size() < 3) fail("a vertex takes three numbers");
    positions_.emplace_back(number(rest[0]), number(rest[1]), number(rest[2]));
  } else if (words[0] == "vn") {
    if (rest.size() < 3) fail("a normal takes three numbers");
    const glm::dvec3 normal(number(rest[0]), number(rest[1]), number(rest[2]));
    const double length = glm::length(normal);
    normals_.emplace_back(length > 0.0 ? normal / length : glm::dvec3(0.0));
  } else if (words[0] == "vt") {
    if (rest.empty()) fail("a texture coordinate takes one to three numbers");
    uvs_.emplace_back(number(rest[0]), rest.size() > 1 ? number(rest[1]) : 0.0f);
  } else if (words[0] == "f" || words[0] == "fo") {
    face(rest);
  } else if (std::find(ignored.begin(), ignored.end(), words[0]) == ignored.end()) {
    fail("this is not a Wavefront OBJ statement");
  }
}

void ObjReader::read(std::string_view text) {
  std::string joined;  // lines that end in a backslash go on in the next
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (joined.empty()) line_ = number;
    if (line.ends_with('\\')) {
      line.remove_suffix(1);
      joined.append(line).append(" ");
    } else if (joined.empty()) {
      statement(line);
    } else {
      statement(joined.append(line));
      joined.clear();
    }
  }
  statement(joined);
  if (corners_.empty()) {
    throw InputError(fmt::format("{} holds no faces; export the mesh with its triangles.", name_));
  }
}

bool ObjReader::all_corners_have_normals() const {
  return std::all_of(corners_.begin(), corners_.end(), [&](const Corner& c) {
    return c.normal != none && normals_[c.normal] != glm::vec3(0.0f);
  });
}

bool ObjReader::all_corners_have_uvs() const {
  return std::all_of(corners_.begin(), corners_.end(),
                     [](const Corner& c) { return c.uv != none; });
}

/// One a position: a seam of texture coordinates is no edge of the surface.
std::vector<glm::vec3> ObjReader::smooth_normals() const {
  Mesh surface;
  surface.positions = positions_;
  for (const Corner& c : corners_) surface.indices.push_back(c.position);
  compute_normals(surface);
  return surface.normals;
}

Mesh ObjReader::mesh() const {
  const bool own_normals = all_corners_have_normals(), own_uvs = all_corners_have_uvs();
  const std::vector<glm::vec3> smooth = own_normals ? std::vector<glm::vec3>() : smooth_normals();
  Mesh mesh;
  std::unordered_map<Corner, std::uint32_t, CornerHash> vertices;
  for (Corner c : corners_) {
    if (!own_normals) c.normal = none;
    if (!own_uvs) c.uv = none;
    const auto next = static_cast<std::uint32_t>(mesh.positions.size());
    const auto [found, is_new] = vertices.try_emplace(c, next);
    mesh.indices.push_back(found->second);
    if (!is_new) continue;
    mesh.positions.push_back(positions_[c.position]);
    mesh.normals.push_back(own_normals ? normals_[c.normal] : smooth[c.position]);
    if (own_uvs) mesh.uvs.push_back(uvs_[c.uv]);
  }
  return mesh;
}

}  // namespace

Mesh read_obj(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) {
    throw InputError(fmt::format("{} is not a file that can be read.", file.string()));
  }
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (!error && size > max_text) {
    throw InputError(fmt::format("{} is larger than 64 MiB; simplify the mesh.", file.string()));
  }
  std::string text(static_cast<std::size_t>(error ? 0 : size), '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (error || !stream) {
    throw InputError(fmt::format("{} cannot be read; look at its permissions.", file.string()));
  }
  ObjReader reader(file.string());
  reader.read(text);
  return reader.mesh();
}

}  // namespace shadowlab::scene
