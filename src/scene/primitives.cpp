#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "scene/limits.h"
#include "scene/mesh.h"

namespace shadowlab::scene {

namespace {

/// As many as keep a rows × columns mesh within `max_triangles`.
constexpr int max_divisions = 1024;

void add_vertex(Mesh& mesh, const glm::dvec3& position, const glm::dvec3& normal,
                const glm::dvec2& uv) {
  // Adding zero turns -0 into +0: equal positions then are equal bits too.
  mesh.positions.push_back(glm::vec3(position) + 0.0f);
  mesh.normals.push_back(glm::vec3(normal) + 0.0f);
  mesh.uvs.emplace_back(uv);
}

void add_triangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  mesh.indices.insert(mesh.indices.end(), {a, b, c});
}

/// A flat quad or triangle with vertices of its own: corners counter-clockwise from outside.
template <std::size_t N>
void add_face(Mesh& mesh, const std::array<glm::dvec3, N>& corners,
              const std::array<glm::dvec2, N>& uvs) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const glm::dvec3 normal =
      glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
  for (std::size_t i = 0; i < N; ++i) add_vertex(mesh, corners[i], normal, uvs[i]);
  for (std::uint32_t i = 2; i < N; ++i) add_triangle(mesh, first, first + i - 1, first + i);
}

/// Triangles of a grid of vertices, `columns` + 1 in each of `rows` + 1 rows; counter-clockwise for
/// an eye that sees columns go right and rows go down.
void add_grid_triangles(Mesh& mesh, int columns, int rows) {
  const auto stride = static_cast<std::uint32_t>(columns) + 1;
  for (std::uint32_t row = 0; row < static_cast<std::uint32_t>(rows); ++row) {
    for (std::uint32_t column = 0; column + 1 < stride; ++column) {
      const std::uint32_t a = row * stride + column, b = a + 1, c = a + stride, d = c + 1;
      add_triangle(mesh, a, c, d);
      add_triangle(mesh, a, d, b);
    }
  }
}

/// Points of the unit circle. The last is the first, bit for bit: what turns around it is closed.
std::vector<glm::dvec2> circle(int points) {
  std::vector<glm::dvec2> out;
  for (int i = 0; i <= points; ++i) {
    const double angle = 2.0 * std::numbers::pi * (i % points) / points;
    out.emplace_back(std::cos(angle), std::sin(angle));
  }
  return out;
}

const std::array<glm::dvec2, 4> quad_uvs{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};

}  // namespace

Mesh grid(double width, double depth, int columns, int rows, std::span<const double> heights) {
  check_length("grid's width", width);
  check_length("grid's depth", depth);
  check_count("grid's number of columns", columns, 1, max_divisions);
  check_count("grid's number of rows", rows, 1, max_divisions);
  const auto needed = static_cast<std::size_t>(columns + 1) * static_cast<std::size_t>(rows + 1);
  if (heights.size() != needed) {
    throw InputError(fmt::format("The grid has {} heights; {} columns and {} rows take {}.",
                                 heights.size(), columns, rows, needed));
  }
  Mesh mesh;
  std::size_t next = 0;
  for (int row = 0; row <= rows; ++row) {
    for (int column = 0; column <= columns; ++column, ++next) {
      const double u = static_cast<double>(column) / columns;
      const double v = static_cast<double>(row) / rows;
      if (!(std::abs(heights[next]) <= 1e9)) {
        throw InputError(fmt::format("The grid's height {} is {}; it must be within -1e9 and 1e9.",
                                     next, heights[next]));
      }
      add_vertex(mesh, {width * (u - 0.5), heights[next], depth * (v - 0.5)}, {0, 1, 0},
                 {u, 1.0 - v});
    }
  }
  add_grid_triangles(mesh, columns, rows);
  compute_normals(mesh);
  return mesh;
}

Mesh plane(double width, double depth, int columns, int rows) {
  check_length("plane's width", width);
  check_length("plane's depth", depth);
  check_count("plane's number of columns", columns, 1, max_divisions);
  check_count("plane's number of rows", rows, 1, max_divisions);
  const std::vector<double> flat(
      static_cast<std::size_t>(columns + 1) * static_cast<std::size_t>(rows + 1), 0.0);
  return grid(width, depth, columns, rows, flat);
}

Mesh quad() {
  Mesh mesh;
  add_face<4>(mesh, {{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}}, quad_uvs);
  return mesh;
}

Mesh box(glm::dvec3 size) {
  check_length("box's width", size.x);
  check_length("box's height", size.y);
  check_length("box's depth", size.z);
  const glm::dvec3 half = size * 0.5;
  Mesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      // (normal, u, v) right-handed: the corners go counter-clockwise seen from the normal's end.
      glm::dvec3 normal(0.0), u(0.0), v(0.0);
      normal[axis] = side * half[axis];
      u[(axis + 1) % 3] = side * half[(axis + 1) % 3];
      v[(axis + 2) % 3] = half[(axis + 2) % 3];
      add_face<4>(mesh, {normal - u - v, normal + u - v, normal + u + v, normal - u + v}, quad_uvs);
    }
  }
  return mesh;
}

Mesh sphere(double radius, int slices, int stacks) {
  check_length("sphere's radius", radius);
  check_count("sphere's number of slices", slices, 3, max_divisions);
  check_count("sphere's number of stacks", stacks, 2, max_divisions);
  const std::vector<glm::dvec2> around = circle(slices);
  Mesh mesh;
  for (int stack = 0; stack <= stacks; ++stack) {
    const double angle = std::numbers::pi * stack / stacks;
    // The poles are points exactly, which sin(π) in floating point is not.
    const bool pole = stack == 0 || stack == stacks;
    const double ring = pole ? 0.0 : std::sin(angle);
    const double height = pole ? (stack == 0 ? 1.0 : -1.0) : std::cos(angle);
    for (int slice = 0; slice <= slices; ++slice) {
      const glm::dvec2 c = around[static_cast<std::size_t>(slice)];
      const glm::dvec3 normal(ring * c.x, height, -ring * c.y);
      // A pole has a vertex for each slice, over the middle of its triangle; the last one is spare.
      const double u = std::min((slice + (pole ? 0.5 : 0.0)) / slices, 1.0);
      add_vertex(mesh, radius * normal, normal, {u, 1.0 - static_cast<double>(stack) / stacks});
    }
  }
  const auto stride = static_cast<std::uint32_t>(slices) + 1;
  const auto last = static_cast<std::uint32_t>(stacks) - 1;
  for (std::uint32_t stack = 0; stack <= last; ++stack) {
    for (std::uint32_t slice = 0; slice + 1 < stride; ++slice) {
      const std::uint32_t a = stack * stride + slice, c = a + stride;
      if (stack != last) add_triangle(mesh, a, c, c + 1);
      if (stack == last) add_triangle(mesh, a, c, a + 1);
      if (stack != 0 && stack != last) add_triangle(mesh, a, c + 1, a + 1);
    }
  }
  return mesh;
}

Mesh torus(double radius, double tube, int slices, int sides) {
  check_length("torus's radius", radius);
  check_length("torus's tube", tube);
  check_count("torus's number of slices", slices, 3, max_divisions);
  check_count("torus's number of sides", sides, 3, max_divisions);
  if (!(tube < radius)) {
    throw InputError(fmt::format(
        "The torus's tube is {} and its radius {}; the tube must be thinner.", tube, radius));
  }
  const std::vector<glm::dvec2> around = circle(slices);
  const std::vector<glm::dvec2> section = circle(sides);
  Mesh mesh;
  // Rows go down the tube's outer side, columns around y: seen from outside, right and down.
  for (int side = 0; side <= sides; ++side) {
    const glm::dvec2 s = section[static_cast<std::size_t>(sides - side)];
    for (int slice = 0; slice <= slices; ++slice) {
      const glm::dvec2 c = around[static_cast<std::size_t>(slice)];
      const glm::dvec3 out(c.x, 0.0, -c.y);
      const glm::dvec3 normal = s.x * out + glm::dvec3(0.0, s.y, 0.0);
      add_vertex(mesh, radius * out + tube * normal, normal,
                 {static_cast<double>(slice) / slices, 1.0 - static_cast<double>(side) / sides});
    }
  }
  add_grid_triangles(mesh, slices, sides);
  return mesh;
}

Mesh tetrahedron(double radius) {
  check_length("tetrahedron's radius", radius);
  const glm::dvec3 top(0.0, radius, 0.0);
  std::array<glm::dvec3, 3> base;  // counter-clockwise seen from above
  for (std::size_t i = 0; i < 3; ++i) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / 3.0;
    const double ring = radius * 2.0 * std::numbers::sqrt2 / 3.0;
    base[i] = {ring * std::cos(angle), -radius / 3.0, -ring * std::sin(angle)};
  }
  const std::array<glm::dvec2, 3> uvs{{{0.5, 1}, {0, 0}, {1, 0}}};
  Mesh mesh;
  for (std::size_t i = 0; i < 3; ++i) {
    add_face<3>(mesh, {top, base[i], base[(i + 1) % 3]}, uvs);
  }
  add_face<3>(mesh, {base[0], base[2], base[1]}, uvs);
  return mesh;
}

}  // namespace shadowlab::scene
