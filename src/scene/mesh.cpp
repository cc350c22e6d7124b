#include "scene/mesh.h"

#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "core/error.h"

namespace shadowlab::scene {

namespace {

template <typename Vector>
bool finite(const Vector& v) {
  for (int i = 0; i < Vector::length(); ++i) {
    if (!std::isfinite(v[i])) return false;
  }
  return true;
}

template <typename Vector>
void check_finite(const std::vector<Vector>& attributes, std::string_view name) {
  for (std::size_t i = 0; i < attributes.size(); ++i) {
    if (!finite(attributes[i])) {
      throw InputError(
          fmt::format("The mesh's {} {} is not finite; give it plain numbers.", name, i));
    }
  }
}

void check_count(std::size_t count, std::size_t positions, std::string_view name) {
  if (count != 0 && count != positions) {
    throw InputError(
        fmt::format("The mesh has {} {} for {} positions; give one a position, or none.", count,
                    name, positions));
  }
}

/// Twice the area of triangle `t` times its unit normal.
glm::dvec3 area_vector(const Mesh& mesh, std::size_t t) {
  const glm::dvec3 a = mesh.positions[mesh.indices[3 * t]];
  const glm::dvec3 b = mesh.positions[mesh.indices[3 * t + 1]];
  const glm::dvec3 c = mesh.positions[mesh.indices[3 * t + 2]];
  return glm::cross(b - a, c - a);
}

void check_affine(const glm::dmat4& m) {
  for (int column = 0; column < 4; ++column) {
    if (!finite(m[column])) {
      throw InputError("A mesh cannot be transformed by a matrix that is not finite.");
    }
    if (m[column].w != (column == 3 ? 1.0 : 0.0)) {
      throw InputError(
          "A mesh can be transformed by an affine matrix only: its last row must be 0 0 0 1.");
    }
  }
}

}  // namespace

void check(const Mesh& mesh) {
  if (mesh.indices.size() % 3 != 0) {
    throw InputError(
        fmt::format("The mesh has {} indices; give three a triangle.", mesh.indices.size()));
  }
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    if (mesh.indices[i] >= mesh.positions.size()) {
      throw InputError(
          fmt::format("The mesh's triangle {} names vertex {}, but there are {} (counted from 0).",
                      i / 3, mesh.indices[i], mesh.positions.size()));
    }
  }
  check_count(mesh.normals.size(), mesh.positions.size(), "normals");
  check_count(mesh.uvs.size(), mesh.positions.size(), "uvs");
  check_finite(mesh.positions, "position");
  check_finite(mesh.normals, "normal");
  check_finite(mesh.uvs, "uv");
}

void compute_normals(Mesh& mesh) {
  std::vector<glm::dvec3> sums(mesh.positions.size(), glm::dvec3(0.0));
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const glm::dvec3 area = area_vector(mesh, t);
    for (std::size_t corner = 0; corner < 3; ++corner) sums[mesh.indices[3 * t + corner]] += area;
  }
  mesh.normals.clear();
  mesh.normals.reserve(sums.size());
  for (const glm::dvec3& sum : sums) {
    const double length = glm::length(sum);
    // A vertex of no triangle, or of degenerate ones only, faces nowhere: up is as good as any.
    mesh.normals.emplace_back(length > 0.0 ? sum / length : glm::dvec3(0.0, 1.0, 0.0));
  }
}

Bounds bounds(const Mesh& mesh, const glm::dmat4& model) {
  Bounds box;
  for (const glm::vec3& position : mesh.positions) {
    const glm::dvec3 moved(model * glm::dvec4(position, 1.0));
    box.low = glm::min(box.low, moved);
    box.high = glm::max(box.high, moved);
  }
  return box;
}

Bounds merge(const Bounds& a, const Bounds& b) {
  return {glm::min(a.low, b.low), glm::max(a.high, b.high)};
}

Mesh transformed(const Mesh& mesh, const glm::dmat4& matrix) {
  check_affine(matrix);
  const glm::dmat3 linear(matrix);
  const double determinant = glm::determinant(linear);
  const double scale = glm::length(linear[0]) * glm::length(linear[1]) * glm::length(linear[2]);
  // The volume of the unit cube's image against that of an upright box with the same edges: below
  // this the normals' directions are rounding.
  if (!(std::abs(determinant) > 1e-12 * scale)) {
    throw InputError("A mesh cannot be transformed by a matrix that flattens it.");
  }
  const glm::dmat3 normal_matrix = glm::transpose(glm::inverse(linear));

  Mesh out = mesh;
  for (glm::vec3& position : out.positions) {
    position = glm::vec3(matrix * glm::dvec4(position, 1.0));
  }
  for (glm::vec3& normal : out.normals) {
    const glm::dvec3 turned = normal_matrix * glm::dvec3(normal);
    const double length = glm::length(turned);
    if (length > 0.0) normal = glm::vec3(turned / length);
  }
  if (determinant < 0.0) {
    for (std::size_t t = 0; t < out.triangle_count(); ++t) {
      std::swap(out.indices[3 * t + 1], out.indices[3 * t + 2]);
    }
  }
  check(out);
  return out;
}

std::optional<glm::dvec4> plane_of(const Mesh& mesh, const glm::dmat4& model) {
  if (mesh.positions.empty()) return std::nullopt;
  // Relative to one vertex, so that a model matrix that leads far away costs no digits.
  const glm::dvec3 base = mesh.positions.front();
  const glm::dmat3 linear(model);
  const auto local = [&](std::size_t i) { return linear * (glm::dvec3(mesh.positions[i]) - base); };

  glm::dvec3 mean(0.0), low(0.0), high(0.0);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    mean += local(i);
    low = glm::min(low, local(i));
    high = glm::max(high, local(i));
  }
  mean /= static_cast<double>(mesh.positions.size());

  glm::dvec3 sum(0.0), largest(0.0);
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const glm::dvec3 a = local(mesh.indices[3 * t]);
    const glm::dvec3 area =
        glm::cross(local(mesh.indices[3 * t + 1]) - a, local(mesh.indices[3 * t + 2]) - a);
    sum += area;
    if (glm::length(area) > glm::length(largest)) largest = area;
  }
  // Triangles that face both ways cancel: then the largest tells the plane.
  const glm::dvec3 facing = glm::length(sum) > 1e-6 * glm::length(largest) ? sum : largest;
  if (!(glm::length(facing) > 0.0)) return std::nullopt;

  const glm::dvec3 normal = glm::normalize(facing);
  const double size = glm::length(high - low);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    if (!(std::abs(glm::dot(normal, local(i) - mean)) <= 1e-6 * size)) return std::nullopt;
  }
  const glm::dvec3 point = glm::dvec3(model * glm::dvec4(base, 1.0)) + mean;
  return glm::dvec4(normal, -glm::dot(normal, point));
}

}  // namespace shadowlab::scene
