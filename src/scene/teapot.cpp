#include <span>
#include <vector>

#include "scene/limits.h"
#include "scene/mesh.h"
#include "scene/teapot_patches.h"

namespace shadowlab::scene {

namespace newell {

namespace {

/// Quarter `quarter` of a ring, counter-clockwise seen from above. Turns by swapping and negating
/// coordinates, so that neighbouring quarters agree bit for bit.
std::array<glm::dvec3, 4> quarter_of(const Ring& ring, int quarter) {
  const double r = ring.radius, b = ring.bulge;
  std::array<glm::dvec3, 4> row{{{r, 0, 0}, {r, b, 0}, {b, r, 0}, {0, r, 0}}};
  for (glm::dvec3& p : row) {
    for (int turn = 0; turn < quarter; ++turn) p = {-p.y, p.x, 0.0};
    p.z = ring.height;
  }
  return row;
}

Patch mirrored(const Patch& half) {
  Patch out = half;
  for (auto& row : out) {
    for (glm::dvec3& p : row) p.y = -p.y;
  }
  return out;
}

Patch columns_reversed(const Patch& patch) {
  Patch out = patch;
  for (auto& row : out) row = {row[3], row[2], row[1], row[0]};
  return out;
}

}  // namespace

std::array<Patch, 32> patches() {
  std::array<Patch, 32> all;
  std::size_t next = 0;
  for (const Strip& strip : strips) {
    for (int quarter = 0; quarter < 4; ++quarter) {
      Patch& patch = all[next++];
      for (std::size_t row = 0; row < 4; ++row) patch[row] = quarter_of(strip[row], quarter);
    }
  }
  for (const Patch& half : halves) {
    // Rows run along the tube; a half's columns run clockwise around it, its mirror image's the
    // other way. Reversing one keeps both outward.
    all[next++] = columns_reversed(half);
    all[next++] = mirrored(half);
  }
  return all;
}

}  // namespace newell

namespace {

using newell::Patch;

/// The height of Newell's table: the knob's top.
constexpr double table_height = 3.15;

/// As many quads a patch as keep the teapot within `max_triangles`.
constexpr int max_teapot_divisions = 128;

using Weights = std::array<double, 4>;

Weights bernstein(double t) {
  const double s = 1.0 - t;
  return {s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t};
}

Weights bernstein_derivative(double t) {
  const double s = 1.0 - t;
  return {-3.0 * s * s, 3.0 * s * s - 6.0 * s * t, 6.0 * s * t - 3.0 * t * t, 3.0 * t * t};
}

/// At u, v = 0 or 1 the weights of all but one row or column are exact zeros: two patches that
/// share a border's control points in the same order give the same points there, bit for bit.
glm::dvec3 weighted(const Patch& patch, const Weights& u, const Weights& v) {
  glm::dvec3 sum(0.0);
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t column = 0; column < 4; ++column)
      sum += u[row] * v[column] * patch[row][column];
  }
  return sum;
}

/// One of the steps in which a patch is walked through, in either direction.
struct Step {
  double at;
  Weights weights, slopes;
};

std::vector<Step> steps(int divisions) {
  std::vector<Step> all;
  for (int i = 0; i <= divisions; ++i) {
    const double at = static_cast<double>(i) / divisions;
    all.push_back({at, bernstein(at), bernstein_derivative(at)});
  }
  return all;
}

/// The outward normal at (u, v), u along the rows. Where a border has shrunk to a point, ∂S/∂v is
/// zero; near it ∂S/∂v ≈ (u − u₀) ∂²S/∂u∂v, which takes its place.
glm::dvec3 normal_at(const Patch& patch, const Step& u, const Step& v) {
  const glm::dvec3 du = weighted(patch, u.slopes, v.weights);
  glm::dvec3 dv = weighted(patch, u.weights, v.slopes);
  if (glm::length(dv) < 1e-9) dv = weighted(patch, u.slopes, v.slopes) * (u.at < 0.5 ? 1.0 : -1.0);
  return glm::normalize(glm::cross(du, dv));
}

/// Newell's z up to our y up: a turn around x, so that orientation stays.
glm::vec3 y_up(const glm::dvec3& p) { return glm::vec3(glm::dvec3(p.x, p.z, -p.y)) + 0.0f; }

void add_patch(Mesh& mesh, const Patch& patch, double scale, std::span<const Step> steps) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const auto n = static_cast<std::uint32_t>(steps.size() - 1);
  for (const Step& u : steps) {
    for (const Step& v : steps) {
      mesh.positions.push_back(y_up(scale * weighted(patch, u.weights, v.weights)));
      mesh.normals.push_back(y_up(normal_at(patch, u, v)));
      mesh.uvs.emplace_back(v.at, 1.0 - u.at);
    }
  }
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const glm::dvec3 p = mesh.positions[a], q = mesh.positions[b], r = mesh.positions[c];
    if (glm::cross(q - p, r - p) != glm::dvec3(0.0)) {
      mesh.indices.insert(mesh.indices.end(), {a, b, c});
    }
  };
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < n; ++j) {
      const std::uint32_t a = first + i * (n + 1) + j, c = a + n + 1;
      add(a, c, c + 1);
      add(a, c + 1, a + 1);
    }
  }
}

}  // namespace

Mesh teapot(double size, int divisions) {
  check_length("teapot's size", size);
  check_count("teapot's number of divisions", divisions, 1, max_teapot_divisions);
  const auto walked = steps(divisions);
  const auto patches = newell::patches();
  const std::size_t points = patches.size() * walked.size() * walked.size();
  Mesh mesh;
  mesh.positions.reserve(points);
  mesh.normals.reserve(points);
  mesh.uvs.reserve(points);
  mesh.indices.reserve(6 * points);
  for (const Patch& patch : patches) add_patch(mesh, patch, size / table_height, walked);
  return mesh;
}

}  // namespace shadowlab::scene
