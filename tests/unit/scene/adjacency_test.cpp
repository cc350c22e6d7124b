#include "scene/adjacency.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "core/error.h"

namespace shadowlab::scene {
namespace {

Mesh tetra() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.indices = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  return mesh;
}

/// The same triangles, each with vertices of its own.
Mesh exploded(const Mesh& mesh) {
  Mesh out;
  for (const std::uint32_t i : mesh.indices) {
    out.indices.push_back(static_cast<std::uint32_t>(out.positions.size()));
    out.positions.push_back(mesh.positions[i]);
  }
  return out;
}

Mesh random_soup(unsigned seed, int triangles, int vertices) {
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

int multiplicity(const Adjacency& mesh, std::size_t edge) {
  int sum = 0;
  for (const Incidence& i : mesh.at(edge)) sum += i.sign();
  return sum;
}

TEST(Adjacency, of_a_tetrahedron_is_six_edges_of_two_opposite_triangles) {
  const Adjacency mesh = adjacency(tetra());
  ASSERT_EQ(mesh.edges.size(), 6u);
  for (std::size_t e = 0; e < 6; ++e) {
    ASSERT_EQ(mesh.at(e).size(), 2u);
    EXPECT_EQ(mesh.at(e)[0].sign(), +1);
    EXPECT_EQ(mesh.at(e)[1].sign(), -1);
    EXPECT_LT(mesh.at(e)[0].triangle(), mesh.at(e)[1].triangle());
  }
  EXPECT_EQ(mesh.closed, std::vector<std::uint8_t>{1});
}

TEST(Adjacency, of_any_soup_holds_each_half_edge_once_with_its_direction) {
  const Adjacency mesh = adjacency(random_soup(3, 400, 20));
  std::vector<std::array<int, 3>> seen(mesh.triangles.size(), {0, 0, 0});
  std::size_t last_first = 0;
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    const auto [a, b] = mesh.edges[e];
    EXPECT_GE(mesh.at(e)[0].triangle(), last_first);
    last_first = mesh.at(e)[0].triangle();
    for (const Incidence& i : mesh.at(e)) {
      const Triangle& t = mesh.triangles[i.triangle()];
      const std::uint32_t from = i.sign() > 0 ? a : b, to = i.sign() > 0 ? b : a;
      int found = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        if (t[k] != from || t[(k + 1) % 3] != to) continue;
        ++seen[i.triangle()][k];
        ++found;
      }
      EXPECT_EQ(found, 1);
    }
  }
  for (const auto& triangle : seen) EXPECT_EQ(triangle, (std::array{1, 1, 1}));
  auto undirected = mesh.edges;
  for (auto& edge : undirected) std::sort(edge.begin(), edge.end());
  std::sort(undirected.begin(), undirected.end());
  EXPECT_EQ(std::adjacent_find(undirected.begin(), undirected.end()), undirected.end());
}

TEST(Adjacency, joins_vertices_by_position_and_minus_zero_is_zero) {
  Mesh soup = exploded(tetra());
  for (std::size_t i = 0; i < soup.positions.size(); i += 2) {
    for (int k = 0; k < 3; ++k) {
      if (soup.positions[i][k] == 0) soup.positions[i][k] = -0.0f;
    }
  }
  const Adjacency mesh = adjacency(soup);
  EXPECT_EQ(mesh.positions.size(), 4u);
  EXPECT_EQ(mesh.edges.size(), 6u);
  EXPECT_EQ(mesh.closed, std::vector<std::uint8_t>{1});
}

TEST(Adjacency, joins_within_the_tolerance_and_not_beyond) {
  Mesh soup = exploded(tetra());
  std::mt19937 random(4);
  std::uniform_real_distribution<float> noise(-5e-4f, 5e-4f);
  for (auto& p : soup.positions) p += glm::vec3(noise(random), noise(random), noise(random));
  EXPECT_EQ(adjacency(soup).positions.size(), 12u);
  // No two of one corner are farther apart than sqrt(3) * 1e-3.
  EXPECT_EQ(adjacency(soup, {2e-3}).positions.size(), 4u);
  EXPECT_EQ(adjacency(soup, {2e-3}).closed, std::vector<std::uint8_t>{1});
  EXPECT_THROW(adjacency(soup, {-1}), InputError);
  EXPECT_THROW(adjacency(soup, {1e-300}), InputError);
  EXPECT_THROW(adjacency(soup, {std::nan("")}), InputError);
}

TEST(Adjacency, drops_triangles_without_area_and_says_where_the_rest_came_from) {
  Mesh mesh = tetra();
  mesh.positions.emplace_back(0.5f, 0.0f, 0.0f);
  // Twice the same corner; three on one line; then a true one.
  mesh.indices.insert(mesh.indices.begin(), {1, 1, 2, 0, 4, 1, 0, 2, 1});
  const Adjacency built = adjacency(mesh);
  EXPECT_EQ(built.source, (std::vector<std::uint32_t>{2, 3, 4, 5, 6}));
}

TEST(Adjacency, of_a_wrongly_turned_triangle_has_edges_of_multiplicity_two) {
  Mesh mesh = tetra();
  std::swap(mesh.indices[0], mesh.indices[1]);
  const Adjacency built = adjacency(mesh);
  int twice = 0;
  for (std::size_t e = 0; e < built.edges.size(); ++e)
    twice += std::abs(multiplicity(built, e)) == 2;
  EXPECT_EQ(twice, 3);
  EXPECT_EQ(built.closed, std::vector<std::uint8_t>{0});
}

TEST(Adjacency, knows_which_components_are_closed) {
  Mesh mesh = tetra();
  for (const std::uint32_t i : tetra().indices) mesh.indices.push_back(i + 4);
  for (const glm::vec3& p : tetra().positions) mesh.positions.push_back(p + 5.0f);
  mesh.indices.resize(mesh.indices.size() - 3);  // the second one lacks a face
  // A third shares a vertex with the first, and no edge.
  mesh.indices.insert(mesh.indices.end(), {0, 8, 9, 0, 9, 8});
  mesh.positions.insert(mesh.positions.end(), {{-1, 0, 0}, {-1, -1, 0}});
  const Adjacency built = adjacency(mesh);
  EXPECT_EQ(built.closed, (std::vector<std::uint8_t>{1, 0, 1}));
  EXPECT_EQ(built.component, (std::vector<std::uint32_t>{0, 0, 0, 0, 1, 1, 1, 2, 2}));
}

TEST(Next, is_the_face_across_each_edge_and_back) {
  const Adjacency mesh = adjacency(tetra());
  const auto across = next(mesh);
  for (std::int32_t t = 0; t < 4; ++t) {
    for (const std::int32_t n : across[static_cast<std::size_t>(t)]) {
      ASSERT_GE(n, 0);
      const auto& back = across[static_cast<std::size_t>(n)];
      EXPECT_EQ(std::count(back.begin(), back.end(), t), 1);
    }
  }
}

TEST(Next, is_none_at_a_border_and_where_three_faces_meet) {
  Mesh fin;
  fin.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
  fin.indices = {0, 1, 2, 1, 0, 3, 0, 1, 4};
  for (const auto& triangle : next(adjacency(fin))) {
    EXPECT_EQ(triangle, (std::array<std::int32_t, 3>{-1, -1, -1}));
  }
}

TEST(IndicesWithAdjacency, name_the_vertex_across_each_edge) {
  const Adjacency mesh = adjacency(tetra());
  const auto indices = indices_with_adjacency(mesh);
  ASSERT_EQ(indices.size(), 24u);
  for (std::size_t t = 0; t < 4; ++t) {
    // In a tetrahedron the vertex across any edge of a face is the one that the face lacks.
    const auto& [a, b, c] = mesh.triangles[t];
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(indices[6 * t + 2 * k], mesh.triangles[t][k]);
      EXPECT_EQ(indices[6 * t + 2 * k + 1], 6 - a - b - c);
    }
  }
}

TEST(Adjacency, of_a_fan_round_one_vertex_takes_no_quadratic_time) {
  Mesh fan;
  fan.positions.emplace_back(0, 1, 0);
  const std::uint32_t count = 200'000;
  for (std::uint32_t i = 0; i < count; ++i) {
    const double angle = 6.283185307179586 * i / count;
    fan.positions.emplace_back(1000 * std::cos(angle), 0, 1000 * std::sin(angle));
    fan.indices.insert(fan.indices.end(), {0, i + 1, (i + 1) % count + 1});
  }
  const auto begin = std::chrono::steady_clock::now();
  const Adjacency built = adjacency(fan);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  EXPECT_EQ(built.edges.size(), 2 * count);
  // n log n takes 0.05 s here; comparing each pair of the 2e5 would take minutes.
  EXPECT_LT(took.count(), 10);
}

TEST(Adjacency, refuses_what_is_no_mesh) {
  Mesh mesh = tetra();
  mesh.indices[5] = 4;
  EXPECT_THROW(adjacency(mesh), InputError);
  mesh = tetra();
  mesh.positions[1].y = std::nanf("");
  EXPECT_THROW(adjacency(mesh), InputError);
}

TEST(Adjacency, of_nothing_is_nothing) {
  const Adjacency built = adjacency(Mesh{});
  EXPECT_TRUE(built.edges.empty());
  EXPECT_EQ(built.begin.size(), 1u);
}

}  // namespace
}  // namespace shadowlab::scene
