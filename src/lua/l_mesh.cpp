// mesh: primitives, files, and meshes built from tables.
#include <fmt/format.h>

#include <cmath>

#include "lua/boxes.h"

namespace shadowlab::lua {
namespace {

constexpr std::size_t most_numbers = 12'000'000;

double number(lua_State* L, int index, const char* function, double otherwise) {
  if (lua_isnoneornil(L, index)) return otherwise;
  return read<double>(L, index, fmt::format("argument {} of mesh.{}", index, function).c_str());
}

int integer(lua_State* L, int index, const char* function, int otherwise) {
  const double value = number(L, index, function, otherwise);
  if (value != std::floor(value) || std::abs(value) > 1e6) {
    throw InputError(
        fmt::format("argument {} of mesh.{} must be an integer; it is {}", index, function, value));
  }
  return static_cast<int>(value);
}

int give(lua_State* L, scene::Mesh mesh) {
  State& state = State::of(L);
  state.check_budget(mesh.indices.size());
  push_box<MeshBox>(L, hold(state, std::move(mesh)));
  return 1;
}

int plane(lua_State* L) {
  return give(L, scene::plane(number(L, 1, "plane", 1), number(L, 2, "plane", 1),
                              integer(L, 3, "plane", 1), integer(L, 4, "plane", 1)));
}

int quad(lua_State* L) { return give(L, scene::quad()); }

int box(lua_State* L) {
  if (const auto* size = test<glm::dvec3>(L, 1)) return give(L, scene::box(*size));
  const double width = number(L, 1, "box", 1);
  return give(L, scene::box({width, number(L, 2, "box", width), number(L, 3, "box", width)}));
}

int sphere(lua_State* L) {
  return give(L, scene::sphere(number(L, 1, "sphere", 0.5), integer(L, 2, "sphere", 32),
                               integer(L, 3, "sphere", 16)));
}

int torus(lua_State* L) {
  return give(L, scene::torus(number(L, 1, "torus", 0.5), number(L, 2, "torus", 0.2),
                              integer(L, 3, "torus", 48), integer(L, 4, "torus", 24)));
}

int tetrahedron(lua_State* L) {
  return give(L, scene::tetrahedron(number(L, 1, "tetrahedron", 0.5)));
}

int teapot(lua_State* L) {
  return give(L, scene::teapot(number(L, 1, "teapot", 1), integer(L, 2, "teapot", 8)));
}

/// mesh.grid(width, depth, columns, rows, heights): a table of (columns+1)(rows+1), or a function
/// of column and row.
int grid(lua_State* L) {
  const int columns = integer(L, 3, "grid", 0), rows = integer(L, 4, "grid", 0);
  if (columns < 1 || rows < 1 || columns > 2000 || rows > 2000) {
    throw InputError("mesh.grid has 1 to 2000 columns and rows");
  }
  std::vector<double> heights;
  for (int row = 0; row <= rows; ++row) {
    for (int column = 0; column <= columns; ++column) {
      if (lua_isfunction(L, 5)) {
        lua_pushvalue(L, 5);
        lua_pushinteger(L, column);
        lua_pushinteger(L, row);
        lua_call(L, 2, 1);
      } else if (lua_type(L, 5) == LUA_TTABLE) {
        lua_rawgeti(L, 5, static_cast<lua_Integer>(heights.size()) + 1);
      } else {
        throw InputError(
            "argument 5 of mesh.grid must be a table of heights, or a function of column and row; "
            "it is " +
            describe(L, 5));
      }
      heights.push_back(read<double>(L, -1, "a height of mesh.grid"));
      lua_pop(L, 1);
    }
  }
  return give(
      L, scene::grid(number(L, 1, "grid", 1), number(L, 2, "grid", 1), columns, rows, heights));
}

int obj(lua_State* L) {
  if (lua_type(L, 1) != LUA_TSTRING)
    throw InputError("mesh.obj takes the name of a file; it is " + describe(L, 1));
  return give(L, scene::read_obj(find_file(Stage::of(L), lua_tostring(L, 1))));
}

// The numbers of a field of mesh.new's table: {x, y, z, x, y, z, …} or {vec3, vec3, …}.
std::vector<double> numbers(lua_State* L, const char* field, std::size_t each) {
  std::vector<double> all;
  lua_getfield(L, 1, field);
  if (lua_isnil(L, -1)) {
    lua_pop(L, 1);
    return all;
  }
  if (lua_type(L, -1) != LUA_TTABLE)
    throw InputError(fmt::format("mesh.new: {} must be a table; it is {}", field, describe(L, -1)));
  const std::size_t count = lua_rawlen(L, -1);
  if (count > most_numbers)
    throw InputError(fmt::format("mesh.new: {} has {} elements; at most {} are taken", field, count,
                                 most_numbers));
  State::of(L).check_budget(count);
  const int table = lua_gettop(L);
  for (std::size_t i = 1; i <= count; ++i) {
    lua_rawgeti(L, table, static_cast<lua_Integer>(i));
    if (const auto* v3 = each == 3 ? test<glm::dvec3>(L, -1) : nullptr) {
      all.insert(all.end(), {v3->x, v3->y, v3->z});
    } else if (const auto* v2 = each == 2 ? test<glm::dvec2>(L, -1) : nullptr) {
      all.insert(all.end(), {v2->x, v2->y});
    } else {
      all.push_back(
          read<double>(L, -1, fmt::format("mesh.new: element {} of {}", i, field).c_str()));
    }
    lua_pop(L, 1);
  }
  lua_pop(L, 1);
  if (all.size() % each != 0) {
    throw InputError(fmt::format("mesh.new: {} has {} numbers, which is not a multiple of {}",
                                 field, all.size(), each));
  }
  return all;
}

int build(lua_State* L) {
  if (lua_type(L, 1) != LUA_TTABLE) {
    throw InputError(
        "mesh.new takes a table { positions = , indices = , normals = , uvs = }; it is " +
        describe(L, 1));
  }
  scene::Mesh mesh;
  const auto positions = numbers(L, "positions", 3);
  const auto normals = numbers(L, "normals", 3);
  const auto uvs = numbers(L, "uvs", 2);
  for (std::size_t i = 0; i < positions.size(); i += 3)
    mesh.positions.emplace_back(positions[i], positions[i + 1], positions[i + 2]);
  for (std::size_t i = 0; i < normals.size(); i += 3)
    mesh.normals.emplace_back(normals[i], normals[i + 1], normals[i + 2]);
  for (std::size_t i = 0; i < uvs.size(); i += 2) mesh.uvs.emplace_back(uvs[i], uvs[i + 1]);
  for (const double index : numbers(L, "indices", 3)) {
    if (index < 0 || index != std::floor(index) ||
        index >= static_cast<double>(mesh.positions.size())) {
      throw InputError(
          fmt::format("mesh.new: index {} names no vertex; they count from 0 to {}, as in GL",
                      index, static_cast<std::ptrdiff_t>(mesh.positions.size()) - 1));
    }
    mesh.indices.push_back(static_cast<std::uint32_t>(index));
  }
  if (mesh.normals.empty()) scene::compute_normals(mesh);
  scene::check(mesh);
  return give(L, std::move(mesh));
}

int draw_mesh(lua_State* L) {
  MeshBox& mesh = read_box<MeshBox>(L, 1, "mesh:draw: self");
  draw({L, 2, 3}, mesh, glm::dmat4(1), {}, "mesh");
  return 0;
}

int transformed_mesh(lua_State* L) {
  MeshBox& mesh = read_box<MeshBox>(L, 1, "mesh:transformed: self");
  return give(L,
              scene::transformed(*mesh, read<glm::dmat4>(L, 2, "argument 1 of mesh:transformed")));
}

int position(lua_State* L) {
  MeshBox& mesh = read_box<MeshBox>(L, 1, "mesh:position: self");
  const double index = read<double>(L, 2, "argument 1 of mesh:position");
  if (index < 0 || index != std::floor(index) ||
      index >= static_cast<double>(mesh->positions.size())) {
    throw InputError(fmt::format("mesh:position: there is no vertex {}; they count from 0 to {}",
                                 index, static_cast<std::ptrdiff_t>(mesh->positions.size()) - 1));
  }
  push(L, glm::dvec3(mesh->positions[static_cast<std::size_t>(index)]));
  return 1;
}

int triangle(lua_State* L) {
  MeshBox& mesh = read_box<MeshBox>(L, 1, "mesh:triangle: self");
  const double index = read<double>(L, 2, "argument 1 of mesh:triangle");
  if (index < 0 || index != std::floor(index) ||
      index >= static_cast<double>(mesh->triangle_count())) {
    throw InputError(fmt::format("mesh:triangle: there is no triangle {}; they count from 0 to {}",
                                 index, static_cast<std::ptrdiff_t>(mesh->triangle_count()) - 1));
  }
  for (std::size_t i = 0; i < 3; ++i)
    lua_pushinteger(L, mesh->indices[static_cast<std::size_t>(index) * 3 + i]);
  return 3;
}

constexpr Entry functions[] = {
    {"plane", "mesh.plane(width, depth, columns, rows)",
     "A rectangle in y = 0 facing up, 1 by 1 unless given.", guarded<plane>},
    {"quad", "mesh.quad()",
     "The square [-1, 1]² in z = 0: the full-screen quad when drawn without matrices.",
     guarded<quad>},
    {"box", "mesh.box(width, height, depth) or mesh.box(vec3)", "A box around the origin.",
     guarded<box>},
    {"sphere", "mesh.sphere(radius, slices, stacks)", "A sphere around the origin.",
     guarded<sphere>},
    {"torus", "mesh.torus(radius, tube, slices, sides)", "A torus around y.", guarded<torus>},
    {"tetrahedron", "mesh.tetrahedron(radius)",
     "The regular tetrahedron on the sphere of that radius, one vertex up.", guarded<tetrahedron>},
    {"teapot", "mesh.teapot(size, divisions)",
     "The Utah teapot from its Bézier patches, standing on y = 0; size is its height, divisions "
     "the quads along a patch's side.",
     guarded<teapot>},
    {"grid", "mesh.grid(width, depth, columns, rows, heights)",
     "A height field; heights is a table, row by row, or a function of column and row.",
     guarded<grid>},
    {"obj", "mesh.obj(path)",
     "A Wavefront OBJ file beside the recipe. Errors name the file and the line.", guarded<obj>},
    {"new", "mesh.new{positions = , indices = , normals = , uvs = }",
     "A mesh of these numbers, or vec3s. Indices count from 0, as in GL, three a triangle, "
     "counter-clockwise from outside. Without normals they are computed.",
     guarded<build>},
};
constexpr Entry methods[] = {
    {"draw", "m:draw(shader, {view = , projection = , light = , model = , uniform = …})",
     "Draws the mesh with this shader.", guarded<draw_mesh>},
    {"transformed", "m:transformed(mat4) -> mesh", "The mesh moved by an affine matrix.",
     guarded<transformed_mesh>},
    {"position", "m:position(index) -> vec3",
     "The position of a vertex, counting from 0, model space.", guarded<position>},
    {"triangle", "m:triangle(index) -> i, j, k",
     "The three vertices of a triangle, counting from 0.", guarded<triangle>},
};
constexpr std::string_view field_names[] = {"vertices", "triangles", "low", "high"};

}  // namespace

bool BoxTraits<MeshBox>::push_field(lua_State* L, MeshBox& mesh, std::string_view key) {
  if (key == "vertices") {
    lua_pushinteger(L, static_cast<lua_Integer>(mesh->positions.size()));
  } else if (key == "triangles") {
    lua_pushinteger(L, static_cast<lua_Integer>(mesh->triangle_count()));
  } else if (key == "low") {
    push(L, scene::bounds(*mesh).low);
  } else if (key == "high") {
    push(L, scene::bounds(*mesh).high);
  } else {
    return false;
  }
  return true;
}

std::span<const std::string_view> BoxTraits<MeshBox>::fields() { return field_names; }

MeshBox hold(State& state, scene::Mesh mesh) {
  const std::size_t bytes = mesh.positions.size() * sizeof(glm::vec3) * 2 +
                            mesh.uvs.size() * sizeof(glm::vec2) +
                            mesh.indices.size() * sizeof(std::uint32_t);
  auto held = std::make_unique<const scene::Mesh>(std::move(mesh));
  try {
    state.reserve(bytes);
  } catch (const InputError&) {
    // Lua does not see how large its garbage is.
    lua_gc(state.raw(), LUA_GCCOLLECT);
    state.reserve(bytes);
  }
  const auto release = [&state, bytes](const scene::Mesh* dead) {
    delete dead;
    state.release(bytes);
  };
  return {held.release(), release};
}

std::span<const Entry> mesh_functions() { return functions; }
std::span<const Entry> mesh_methods() { return methods; }

void open_mesh(Stage& stage) {
  lua_State* L = stage.state.raw();
  open_box<MeshBox>(L, methods);
  lua_newtable(L);
  set_functions(L, functions);
  refuse_unknown_names(L, -1, "mesh");
  lua_setglobal(L, "mesh");
}

}  // namespace shadowlab::lua
