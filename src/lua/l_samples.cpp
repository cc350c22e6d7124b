// shadow.samples: an area light as the points that a recipe draws one by one.
#include "lua/sampling.h"

#include <fmt/format.h>

#include <cmath>

#include "core/near_names.h"
#include "shadow/penumbra.h"

namespace shadowlab::lua {
namespace {

int samples(lua_State* L) {
  const auto light = read_light(L, 1, "argument 1 of shadow.samples (the light)");
  const double n = read<double>(L, 2, "argument 2 of shadow.samples (how many)");
  if (!(n >= 1 && n <= most_samples) || n != std::floor(n)) {
    throw InputError(
        fmt::format("shadow.samples gives from 1 to {} points, a whole number; {} were asked for",
                    most_samples, n));
  }
  const auto pattern =
      lua_isnoneornil(L, 3) ? shadow::Pattern::owen : read_pattern(L, 3, "shadow.samples");
  const auto seed = lua_isnoneornil(L, 4) ? 0 : read_seed(L, 4, "shadow.samples");
  const auto points = shadow::samples(light, static_cast<int>(n), pattern, seed);
  lua_createtable(L, static_cast<int>(n), 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    push(L, glm::dvec4(points[i], 1));
    lua_rawseti(L, -2, static_cast<lua_Integer>(i) + 1);
  }
  return 1;
}

int samples_needed(lua_State* L) {
  const SceneBox scene =
      read_box<SceneBox>(L, 1, "argument 1 of shadow.samples_needed (the scene)");
  const auto& camera = read_box<CameraBox>(L, 2, "argument 2 of shadow.samples_needed").camera();
  const auto light = read_light(L, 3, "argument 3 of shadow.samples_needed (the light)");
  const double error = read<double>(L, 4, "argument 4 of shadow.samples_needed (the error)");
  if (!(error > 0)) {
    throw InputError(
        "shadow.samples_needed: the error is a number over 0, of visibility over the picture");
  }
  Stage& stage = Stage::of(L);
  for (const auto& object : scene->objects) stage.state.check_budget(object.mesh->indices.size());
  const auto penumbra = shadow::penumbra(*scene, camera, light, stage.picture_size());
  const int points = shadow::points_for(penumbra, error);
  if (stage.explaining) {
    stage.explain(fmt::format(
        "The penumbra is {:.1f} pixels wide and {:.2f} % of the picture: {} of Owen's points are "
        "expected to leave an error of {:.2g} over the picture, where {:g} was asked for.",
        penumbra.width, 100 * penumbra.share, points, shadow::expected_error(penumbra, points),
        error));
  }
  lua_pushinteger(L, points);
  lua_createtable(L, 0, 2);
  lua_pushnumber(L, penumbra.width);
  lua_setfield(L, -2, "width");
  lua_pushnumber(L, penumbra.share);
  lua_setfield(L, -2, "share");
  return 2;
}

int error_of_halves(lua_State* L) {
  lua_pushnumber(
      L, shadow::error_of_halves(read<double>(L, 1, "argument 1 of shadow.error_of_halves")));
  return 1;
}

constexpr Entry functions[] = {
    {"samples",
     "shadow.samples(light, n, \"random\"|\"jitter\"|\"grid\"|\"hammersley\"|\"r2\"|\"sobol\"|"
     "\"owen\", seed) -> {vec4, …}",
     "n points on an area light, each a light of its own (w = 1); \"owen\", Sobol's sequence under "
     "Owen's scrambling, unless another pattern is given. A light is { center = , u = , v = }, a "
     "rectangle of these half-axes, the same with disk = true, an ellipse, or { center = , radius "
     "= }, a sphere; a point gives itself n times. The same seed (0) gives the same points; of "
     "\"random\", \"r2\", \"sobol\" and \"owen\" the first points of many are the points of fewer.",
     guarded<samples>},
    {"samples_needed",
     "shadow.samples_needed(scene, camera, light, error) -> n, {width = , share = }",
     "How many points of \"owen\" a light with a size is expected to need for an RMSE of "
     "visibility over the picture of at most error, a power of two: by the penumbra along the "
     "casters' silhouettes, width pixels wide, which is a share of the picture.",
     guarded<samples_needed>},
    {"error_of_halves", "shadow.error_of_halves(difference) -> number",
     "The error of a mean over N points, of which the first and the second half have means that "
     "differ by so much (RMS over the picture): half of it, which is not too little for any "
     "pattern that is as good as random points.",
     guarded<error_of_halves>},
};

}  // namespace

shadow::Pattern read_pattern(lua_State* L, int index, const char* function) {
  if (lua_type(L, index) != LUA_TSTRING) {
    throw InputError(fmt::format("{}: a pattern is a name, as \"owen\"; it is {}", function,
                                 describe(L, index)));
  }
  const std::string_view text = lua_tostring(L, index);
  if (const auto pattern = shadow::pattern_named(text)) return *pattern;
  throw InputError(fmt::format("{}: there is no pattern \"{}\"{}", function, text,
                               did_you_mean(text, shadow::pattern_names())));
}

std::uint64_t read_seed(lua_State* L, int index, const char* function) {
  const double seed = read<double>(L, index, "seed");
  if (!(seed >= 0 && seed < 0x1p53) || seed != std::floor(seed))
    throw InputError(fmt::format("{}: a seed is a whole number, not negative", function));
  return static_cast<std::uint64_t>(seed);
}

std::span<const Entry> sample_functions() { return functions; }

}  // namespace shadowlab::lua
