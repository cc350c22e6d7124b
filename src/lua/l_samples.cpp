// shadow.samples: an area light as the points that a recipe draws one by one.
#include "lua/sampling.h"

#include <fmt/format.h>

#include <cmath>

#include "core/near_names.h"

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
