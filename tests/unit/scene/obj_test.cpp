#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "scene/mesh.h"
#include "scene/polygon.h"
#include "topology.h"

namespace shadowlab::scene {
namespace {

class Obj : public testing::Test {
 protected:
  Obj() {
    std::string pattern = testing::TempDir() + "shadowlab_obj_XXXXXX";
    folder_ = mkdtemp(pattern.data());
  }
  ~Obj() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const std::string& text) const {
    std::ofstream(folder_ / "mesh.obj", std::ios::binary) << text;
    return folder_ / "mesh.obj";
  }
  Mesh read(const std::string& text) const { return read_obj(write(text)); }
  std::string error_of(const std::string& text) const {
    try {
      read(text);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  }
  std::filesystem::path folder_;
};

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST_F(Obj, gives_positions_and_triangles_as_written) {
  const Mesh mesh = read("# a comment\no thing\nmtllib no.mtl\r\n\n" + square + "f 1 2 3 # more\n");
  EXPECT_NO_THROW(check(mesh));
  EXPECT_THAT(mesh.positions,
              testing::ElementsAre(glm::vec3(0, 0, 0), glm::vec3(1, 0, 0), glm::vec3(1, 1, 0)));
  EXPECT_THAT(mesh.indices, testing::ElementsAre(0, 1, 2));
  EXPECT_TRUE(mesh.uvs.empty());
}

TEST_F(Obj, reads_numbers_in_all_their_spellings_to_the_nearest_float) {
  const Mesh mesh = read("v +1 -.5 1e-3\nv 0.1 2. 1E2\nv\t3  16777217 0 1\nf -3 -2 -1");
  EXPECT_EQ(mesh.positions[0], glm::vec3(1.0f, -0.5f, 1e-3f));
  EXPECT_EQ(mesh.positions[1], glm::vec3(0.1f, 2.0f, 100.0f));
  EXPECT_EQ(mesh.positions[2], glm::vec3(3.0f, 16777216.0f, 0.0f));
}

TEST_F(Obj, gives_normals_of_unit_length_and_uvs) {
  const Mesh mesh = read(square + "vn 0 2 0\nvt 0.25 0.75\nf 1/1/1 2/1/1 3/1/1\n");
  EXPECT_THAT(mesh.normals, testing::Each(glm::vec3(0, 1, 0)));
  EXPECT_THAT(mesh.uvs, testing::Each(glm::vec2(0.25, 0.75)));
}

TEST_F(Obj, shares_a_vertex_where_position_uv_and_normal_are_the_same) {
  const std::string two = square + "vn 0 0 1\nvn 0 1 0\nvt 0 0\nvt 1 1\n";
  EXPECT_EQ(read(two + "f 1//1 2//1 3//1\nf 1//1 3//1 4//1\n").positions.size(), 4u);
  EXPECT_EQ(read(two + "f 1//1 2//1 3//1\nf 1//2 3//2 4//2\n").positions.size(), 6u);
  EXPECT_EQ(read(two + "f 1/1 2/1 3/1\nf 1/2 3/2 4/2\n").positions.size(), 6u);
}

TEST_F(Obj, computes_normals_that_are_missing_somewhere_smooth_across_seams_of_uvs) {
  // Two faces over the edge 1-3, at a right angle, of the same area.
  const std::string roof =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0 0 1\nvn 0 0 0\nvt 0 0\nvt 1 1\n";
  for (const char* faces :
       {"f 1 2 3\nf 1 3 4\n", "f 1//1 2//1 3//1\nf 1 3 4\n", "f 1//2 2//2 3//2\nf 1//2 3//2 4//2\n",
        "f 1/1 2/1 3/1\nf 1/2 3/2 4/2\n"}) {
    const Mesh mesh = read(roof + faces);
    const glm::dvec3 expected = glm::normalize(glm::dvec3(1, 0, 1));
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      if (mesh.positions[i] != glm::vec3(0, 0, 0)) continue;
      EXPECT_LT(glm::length(glm::dvec3(mesh.normals[i]) - expected), 1e-7) << faces;  // floats
    }
  }
}

TEST_F(Obj, joins_lines_that_end_in_a_backslash) {
  EXPECT_EQ(read(square + "f 1 2 \\\n 3 \\\r\n 4\n").triangle_count(), 2u);
  EXPECT_THAT(error_of(square + "f 1 2 \\\n 9\n"), testing::HasSubstr("line 5"));
}

TEST_F(Obj, names_file_and_line_of_what_is_broken) {
  const auto expect = [&](const std::string& text, const char* what) {
    const std::string error = error_of(text);
    EXPECT_THAT(error, testing::HasSubstr(what));
    EXPECT_THAT(error, testing::HasSubstr("mesh.obj"));
  };
  expect("v 0 0 0\nv 0 x 0\n", "line 2: a coordinate is not a number");
  expect("v 0 0 0\nv 0 1,5 0\n", "line 2: a coordinate is not a number");
  expect("v 0 0\n", "line 1: a vertex takes three numbers");
  expect("v 0 nan 0\n", "line 1: a coordinate is not finite");
  expect("v 0 1e400 0\n", "line 1: a coordinate is not finite");
  expect("v 0 1e31 0\n", "line 1: a coordinate is not finite");
  expect("vn 0 0\n", "line 1: a normal takes three numbers");
  expect("vt\n", "line 1: a texture coordinate");
  expect(square + "f 1 2\n", "line 5: a face has 2 corners");
  expect(square + "f 1 2 5\n", "line 5: a face names vertex 5, but 4 came before it");
  expect(square + "f 1 2 0\n", "line 5: a face names vertex 0");
  expect(square + "f 1 2 -5\n", "line 5: a face names vertex -5");
  expect(square + "f 1 2 9999999999999999999999\n", "line 5: a face's vertex is not a whole");
  expect(square + "f 1/1 2/1 3/1\n", "line 5: a face names texture coordinate 1, but 0");
  expect(square + "f 1//1 2 3\n", "line 5: a face names normal 1, but 0");
  expect(square + "f 1/2/3/4 2 3\n", "line 5: a face's corner has more");
  expect(square + "f 1 2 three\n", "line 5: a face's vertex is not a whole");
  expect(square, "holds no faces");
  expect("", "holds no faces");
}

TEST_F(Obj, never_quotes_a_file_that_is_none) {
  const std::string error = error_of("root:x:0:0:secret\n");
  EXPECT_THAT(error, testing::HasSubstr("line 1: this is not a Wavefront OBJ statement"));
  EXPECT_THAT(error, testing::Not(testing::HasSubstr("secret")));
}

TEST_F(Obj, refuses_what_is_no_readable_file_or_too_large) {
  EXPECT_THROW(read_obj(folder_ / "missing.obj"), InputError);
  EXPECT_THROW(read_obj(folder_), InputError);
  EXPECT_THROW(read_obj("/dev/zero"), InputError);
  write("");
  std::filesystem::resize_file(folder_ / "mesh.obj", (64u << 20) + 1);
  try {
    read_obj(folder_ / "mesh.obj");
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("64 MiB"));
  }
}

TEST_F(Obj, refuses_more_than_four_million_triangles) {
  std::string text = square;
  std::string fan = "f";
  for (int i = 0; i < 1000; ++i) fan += " 1 2 3";
  for (int i = 0; i < 1400; ++i) text += fan + "\n";
  EXPECT_THAT(error_of(text), testing::HasSubstr("more than 4000000 triangles"));
}

// --- Polygons ----------------------------------------------------------------------------------

double area_of(std::span<const glm::dvec3> corners, std::span<const PolygonTriangle> triangles,
               glm::dvec3 normal) {
  double area = 0.0;
  for (const auto& [a, b, c] : triangles) {
    const double twice =
        glm::dot(normal, glm::cross(corners[b] - corners[a], corners[c] - corners[a]));
    EXPECT_GE(twice, 0.0) << "a triangle turns the other way";
    area += 0.5 * twice;
  }
  return area;
}

TEST(Polygon, concave_is_covered_once_by_triangles_that_turn_its_way) {
  // An arrowhead whose shorter diagonal is outside, a comb, and an L; in three planes, both ways.
  const std::vector<std::pair<std::vector<glm::dvec2>, double>> shapes{
      {{{0, 2}, {-1, -2}, {0, -1.875}, {1, -2}}, 3.875},
      {{{0, 0}, {7, 0}, {7, 3}, {6, 1}, {5, 3}, {4, 1}, {3, 3}, {2, 1}, {1, 3}, {0, 1}}, 14.0},
      {{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 3.0}};
  for (const auto& [shape, area] : shapes) {
    for (int axis = 0; axis < 3; ++axis) {
      for (const double side : {1.0, -1.0}) {
        std::vector<glm::dvec3> corners;
        for (const glm::dvec2& p : shape) {
          glm::dvec3 corner(0.0);
          corner[axis] = 5.0;
          corner[(axis + 1) % 3] = p.x;
          corner[(axis + 2) % 3] = side * p.y;
          corners.push_back(corner);
        }
        glm::dvec3 normal(0.0);
        normal[axis] = side;
        const auto triangles = triangulate(corners);
        EXPECT_EQ(triangles.size(), corners.size() - 2);
        EXPECT_DOUBLE_EQ(area_of(corners, triangles, normal), area);
        EXPECT_FALSE(is_convex(corners));
      }
    }
  }
}

TEST(Polygon, convex_is_a_fan) {
  const std::vector<glm::dvec3> square_corners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  EXPECT_TRUE(is_convex(square_corners));
  EXPECT_THAT(triangulate(square_corners),
              testing::ElementsAre(PolygonTriangle{0, 1, 2}, PolygonTriangle{0, 2, 3}));
}

TEST(Polygon, degenerate_or_crossing_gives_triangles_all_the_same) {
  const std::vector<glm::dvec3> line{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 0, 0}, {3, 0, 0}};
  EXPECT_EQ(triangulate(line).size(), 3u);
  const std::vector<glm::dvec3> bow{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}, {0, 3, 0}};
  EXPECT_EQ(triangulate(bow).size(), 3u);
}

}  // namespace
}  // namespace shadowlab::scene
