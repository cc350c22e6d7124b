// shadow.triangle_grid: a light's map of triangles, as textures' bytes.
#include "lua/map_arguments.h"
#include "lua/modules.h"
#include "shadow/triangle_grid.h"

namespace shadowlab::lua {
namespace {

// Texels of `components` floats, in whole rows: the last is filled up with zeros.
void push_rows(lua_State* L, const char* name, std::span<const float> numbers,
               std::size_t components, std::size_t width) {
  const std::size_t row = components * width;
  const std::size_t rows = std::max<std::size_t>((numbers.size() + row - 1) / row, 1);
  std::vector<float> texels(numbers.begin(), numbers.end());
  texels.resize(rows * row);
  lua_newtable(L);
  lua_pushlstring(L, reinterpret_cast<const char*>(texels.data()), texels.size() * sizeof(float));
  lua_setfield(L, -2, "bytes");
  lua_pushinteger(L, static_cast<lua_Integer>(width));
  lua_setfield(L, -2, "width");
  lua_pushinteger(L, static_cast<lua_Integer>(rows));
  lua_setfield(L, -2, "height");
  lua_setfield(L, -2, name);
}

int triangle_grid(lua_State* L) {
  const auto light = light_argument(L, 1, "triangle_grid");
  const SceneBox& scene = scene_argument(L, 2, "triangle_grid");
  const auto view = read<glm::dmat4>(L, 3, "argument 3 of shadow.triangle_grid (a view)");
  const auto projection =
      read<glm::dmat4>(L, 4, "argument 4 of shadow.triangle_grid (a projection)");
  const int cells = integer_argument(L, 5, "triangle_grid", 1, 4096);
  State& state = Stage::of(L).state;
  std::size_t corners = 0;
  for (const scene::Object& object : scene->objects) corners += object.mesh->indices.size();
  state.check_budget(corners);
  const auto grid = shadow::triangle_grid(*scene, light, view, projection, cells);
  state.check_budget(grid.list.size());
  // Numbers are floats to the shader, whose integers end there.
  if (grid.list.size() > (1u << 24)) {
    throw InputError(fmt::format(
        "the grid would list {} triangles in its cells; at most 2^24 fit: give fewer cells",
        grid.list.size()));
  }

  lua_newtable(L);
  push(L, grid.origin);
  lua_setfield(L, -2, "origin");
  std::vector<float> ranges;
  for (const glm::uvec2 range : grid.ranges) {
    ranges.push_back(static_cast<float>(range.x));
    ranges.push_back(static_cast<float>(range.y));
  }
  push_rows(L, "ranges", ranges, 2, static_cast<std::size_t>(cells));
  push_rows(L, "list", std::vector<float>(grid.list.begin(), grid.list.end()), 1, 1024);
  push_rows(L, "triangles", {&grid.triangles.data()->x, 4 * grid.triangles.size()}, 4, 1024);
  lua_pushinteger(L, static_cast<lua_Integer>(grid.longest));
  lua_setfield(L, -2, "longest");
  lua_pushinteger(L, static_cast<lua_Integer>(grid.list.size()));
  lua_setfield(L, -2, "listed");
  return 1;
}

constexpr Entry functions[] = {
    {"triangle_grid",
     "shadow.triangle_grid(light, scene, view, projection, cells) -> { origin, triangles, ranges, "
     "list, longest, listed }",
     "A map without aliasing, for a light's view and projection: which casters' triangles can "
     "shadow a point of each of cells × cells. triangles, ranges and list are textures, each "
     "{ bytes = , width = , height = } of floats. triangles: RGBA, 1024 a row, 16 for each "
     "triangle of "
     "the scene's objects in their order: its plane and the planes through its edges and the "
     "light, "
     "positive where the light is and inside; the next bits of these; corners a, b, c, each "
     "followed by its next bits; two of zeros; relative to origin, a vec3. ranges: RG, for each "
     "cell where its "
     "numbers begin in the list and how many there are. list: R, 1024 a row. longest: the most "
     "numbers that a "
     "cell has; listed: all.",
     guarded<triangle_grid>},
};

}  // namespace

std::span<const Entry> triangle_grid_functions() { return functions; }

}  // namespace shadowlab::lua
