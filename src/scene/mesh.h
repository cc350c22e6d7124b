// Triangle meshes: what a caster or a receiver is made of.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include <glm/glm.hpp>

namespace shadowlab::scene {

/// A triangle soup with shared vertices, in model space, metres. Floats, since that is what GL
/// draws and so what "exact" means: geometry decides in double or better on these very numbers.
/// Invariant (see `check`): indices.size() is a multiple of 3, each index names a position, normals
/// and uvs are empty or one a position, every number is finite.
struct Mesh {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;  ///< unit length
  std::vector<glm::vec2> uvs;
  std::vector<std::uint32_t> indices;  ///< three a triangle, counter-clockwise seen from outside

  std::size_t triangle_count() const { return indices.size() / 3; }
};

/// An axis-aligned box; empty when low > high.
struct Bounds {
  glm::dvec3 low{+1e300};
  glm::dvec3 high{-1e300};
  bool empty() const { return low.x > high.x; }
  glm::dvec3 center() const { return (low + high) * 0.5; }
  double radius() const { return empty() ? 0.0 : glm::length(high - low) * 0.5; }
};

/// Throws InputError with the first broken invariant of `Mesh`, naming the vertex or triangle.
void check(const Mesh& mesh);

/// Normals from the faces' planes, weighted by area; for a mesh that came without.
void compute_normals(Mesh& mesh);

/// The box of `mesh`'s vertices under `model`, in the space that `model` leads to.
Bounds bounds(const Mesh& mesh, const glm::dmat4& model = glm::dmat4(1.0));
Bounds merge(const Bounds& a, const Bounds& b);

/// `mesh` with positions and normals moved by `matrix` (affine and invertible; else InputError). A
/// matrix that mirrors also turns the triangles, so that they stay counter-clockwise from outside.
Mesh transformed(const Mesh& mesh, const glm::dmat4& matrix);

/// The plane (a, b, c, d), unit normal, that all of `mesh` under `model` lies in, its normal the
/// way the triangles face; nothing where the mesh is not planar within 1e-6 of its size.
std::optional<glm::dvec4> plane_of(const Mesh& mesh, const glm::dmat4& model = glm::dmat4(1.0));

// Primitives, all centred on the origin, y up, with normals and uvs, watertight where they are
// closed.

/// A rectangle in y = 0 facing +y, `columns` × `rows` quads.
Mesh plane(double width, double depth, int columns = 1, int rows = 1);
/// The square [-1, 1]² in z = 0 facing +z: the full-screen quad when drawn without matrices.
Mesh quad();
Mesh box(glm::dvec3 size = glm::dvec3(1.0));
/// Longitude-latitude sphere; `slices` ≥ 3 around y, `stacks` ≥ 2.
Mesh sphere(double radius = 0.5, int slices = 32, int stacks = 16);
/// A torus around y: `radius` to the tube's centre, `tube` its radius.
Mesh torus(double radius = 0.5, double tube = 0.2, int slices = 48, int sides = 24);
/// The regular tetrahedron on the sphere of `radius`, one vertex up.
Mesh tetrahedron(double radius = 0.5);
/// A height field over [-w/2, w/2] × [-d/2, d/2]: heights[row * (columns+1) + column], row along
/// +z.
Mesh grid(double width, double depth, int columns, int rows, std::span<const double> heights);
/// The Utah teapot from its 32 Bézier patches (four of them the bottom), `divisions` × `divisions`
/// quads a patch, 1 to 128, standing on y = 0, `size` = its height, spout toward +x. Newell's
/// original is open between lid and rim and at both ends of spout and handle, which pierce the
/// body: that is kept, since real casters are like that. Degenerate triangles are left out.
Mesh teapot(double size = 1.0, int divisions = 8);

/// Reads a Wavefront OBJ (positions, normals, uvs, polygons triangulated; materials ignored).
/// Errors name the file and the line. Limits: 64 MiB of text, 4 million triangles.
Mesh read_obj(const std::filesystem::path& file);

}  // namespace shadowlab::scene
