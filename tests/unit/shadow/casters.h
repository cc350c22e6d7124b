// Casters of all kinds, kind and malicious.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "scene/mesh.h"

namespace shadowlab::shadow {

using scene::Mesh;

/// Both meshes as one, without normals.
inline Mesh joined(Mesh a, const Mesh& b) {
  a.normals.clear();
  a.uvs.clear();
  const auto first = static_cast<std::uint32_t>(a.positions.size());
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  for (const std::uint32_t i : b.indices) a.indices.push_back(first + i);
  return a;
}

inline Mesh moved(Mesh mesh, glm::vec3 by, float scale = 1) {
  for (glm::vec3& p : mesh.positions) p = p * scale + by;
  return mesh;
}

inline Mesh turned_round(Mesh mesh) {
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
  }
  return mesh;
}

inline Mesh bare(Mesh mesh) {
  mesh.normals.clear();
  mesh.uvs.clear();
  return mesh;
}

/// A strip with half a turn: no orientation, one border.
inline Mesh mobius(int quads = 40) {
  Mesh mesh;
  for (int i = 0; i <= quads; ++i) {
    const double u = 2 * std::numbers::pi * i / quads;
    for (const double v : {-0.3, 0.3}) {
      const double r = 1 + v * std::cos(u / 2);
      mesh.positions.emplace_back(r * std::cos(u), v * std::sin(u / 2), r * std::sin(u));
    }
  }
  // The last two are the first two, exchanged.
  mesh.positions[mesh.positions.size() - 2] = mesh.positions[1];
  mesh.positions[mesh.positions.size() - 1] = mesh.positions[0];
  for (std::uint32_t i = 0; i < 2 * static_cast<std::uint32_t>(quads); i += 2) {
    mesh.indices.insert(mesh.indices.end(), {i, i + 2, i + 1, i + 1, i + 2, i + 3});
  }
  return mesh;
}

inline Mesh soup(unsigned seed, int triangles, int vertices) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<std::uint32_t> vertex(0, static_cast<std::uint32_t>(vertices - 1));
  std::uniform_real_distribution<float> coordinate(-1, 1);
  Mesh mesh;
  for (int v = 0; v < vertices; ++v) {
    mesh.positions.emplace_back(coordinate(random), coordinate(random), coordinate(random));
  }
  for (int i = 0; i < 3 * triangles; ++i) mesh.indices.push_back(vertex(random));
  return mesh;
}

/// Slivers a millionth as high as they are long, all round a stick.
inline Mesh slivers() {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> coordinate(-1, 1);
  Mesh mesh;
  for (std::uint32_t i = 0; i < 60; ++i) {
    const glm::vec3 a(coordinate(random), coordinate(random), coordinate(random));
    const glm::vec3 b(coordinate(random), coordinate(random), coordinate(random));
    const glm::vec3 off(coordinate(random), coordinate(random), coordinate(random));
    mesh.positions.insert(mesh.positions.end(), {a, b, (a + b) * 0.5f + off * 1e-6f});
    mesh.indices.insert(mesh.indices.end(), {3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

/// Triangles from far away to two vertices so near the origin that doubles round the edges, and the
/// normal, computed from those, is noise.
inline Mesh needles() {
  std::mt19937 random(8);
  std::uniform_real_distribution<float> coordinate(-1, 1);
  const auto point = [&](float reach) {
    return glm::vec3(coordinate(random), coordinate(random), coordinate(random)) * reach;
  };
  Mesh mesh;
  for (std::uint32_t i = 0; i < 40; ++i) {
    mesh.positions.insert(mesh.positions.end(), {point(1), point(1e-13f), point(1e-13f)});
    mesh.indices.insert(mesh.indices.end(), {3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

/// Boxes one in another.
inline Mesh shells(int count) {
  Mesh mesh;
  for (int i = 1; i <= count; ++i) {
    mesh = joined(mesh, moved(scene::box(), {0, 0, 0}, 2 * static_cast<float>(i)));
  }
  return mesh;
}

struct Caster {
  std::string name;
  Mesh mesh;
};

inline std::vector<Caster> casters() {
  const Mesh box = bare(scene::box()), ball = bare(scene::sphere(0.8, 16, 9));
  Mesh twice = box;
  twice.indices.insert(twice.indices.end(), box.indices.begin(), box.indices.begin() + 9);
  // Two triangles with three edges in common.
  Mesh leaf;
  leaf.positions = {{0, 0, 0}, {1, 0.5f, 0}, {0, 1, 0.25f}};
  leaf.indices = {0, 1, 2, 0, 2, 1};
  Mesh wrong = ball;
  for (std::size_t i = 0; i < wrong.indices.size(); i += 15)
    std::swap(wrong.indices[i], wrong.indices[i + 1]);
  Mesh holes = ball;
  for (std::size_t i = 0; i + 3 < holes.indices.size(); i += 12)
    holes.indices.erase(holes.indices.begin() + static_cast<std::ptrdiff_t>(i),
                        holes.indices.begin() + static_cast<std::ptrdiff_t>(i + 3));
  return {
      {"box", box},
      {"ball", ball},
      {"torus", bare(scene::torus(0.6, 0.25, 20, 10))},
      {"teapot", moved(bare(scene::teapot(1.0, 4)), {0, -0.5f, 0})},
      {"mobius", mobius()},
      {"soup", soup(1, 60, 200)},
      {"tangle", soup(2, 80, 12)},
      {"slivers", slivers()},
      {"box with faces twice", twice},
      {"ball with triangles turned", wrong},
      {"ball with holes", holes},
      {"ball inside out", turned_round(ball)},
      {"ball in a box", joined(moved(box, {0, 0, 0}, 1.9f), moved(ball, {0, 0, 0}, 0.7f))},
      {"ball in an inside-out box",
       joined(turned_round(moved(box, {0, 0, 0}, 1.9f)), moved(ball, {0, 0, 0}, 0.7f))},
      {"two balls through each other",
       joined(moved(ball, {0.3f, 0, 0}, 0.8f), moved(ball, {-0.3f, 0.1f, 0}, 0.8f))},
      {"two boxes at one edge", joined(moved(box, {0.5f, 0.5f, 0}), moved(box, {-0.5f, -0.5f, 0}))},
      {"card with two sides", joined(bare(scene::quad()), turned_round(bare(scene::quad())))}};
}

}  // namespace shadowlab::shadow
