// shadow.truth: the exact visibility, for reference and for difference pictures.
#include <fmt/format.h>

#include <array>
#include <cstring>

#include "lua/object.h"
#include "lua/sampling.h"
#include "lua/truth_pool.h"

namespace shadowlab::lua {
namespace {

bool same(const scene::Camera& a, const scene::Camera& b) {
  return a.eye == b.eye && a.target == b.target && a.up == b.up && a.fovy == b.fovy &&
         a.near == b.near && a.far == b.far;
}

bool same(const scene::Light& a, const scene::Light& b) {
  return a.position == b.position && a.shape == b.shape && a.half_u == b.half_u &&
         a.half_v == b.half_v && a.radius == b.radius;
}

bool same(const truth::Sampling& a, const truth::Sampling& b) {
  return a.samples == b.samples && a.pattern == b.pattern && a.seed == b.seed && a.error == b.error;
}

truth::Sampling read_sampling(lua_State* L, int index) {
  truth::Sampling sampling;
  if (lua_isnoneornil(L, index)) return sampling;
  if (lua_type(L, index) != LUA_TTABLE) {
    throw InputError("shadow.truth's options are a table, as { samples = 256 }; it is " +
                     describe(L, index));
  }
  static constexpr std::string_view names[] = {"samples", "pattern", "seed", "error"};
  lua_pushnil(L);
  while (lua_next(L, index)) {
    const std::string key = lua_type(L, -2) == LUA_TSTRING ? lua_tostring(L, -2) : describe(L, -2);
    if (key == "samples") {
      const double samples = read<double>(L, -1, "samples");
      if (!(samples >= 1 && samples <= 65536))
        throw InputError("shadow.truth: samples is from 1 to 65536");
      sampling.samples = static_cast<int>(samples);
    } else if (key == "pattern") {
      sampling.pattern = read_pattern(L, lua_gettop(L), "shadow.truth");
    } else if (key == "seed") {
      sampling.seed = read_seed(L, lua_gettop(L), "shadow.truth");
    } else if (key == "error") {
      sampling.error = read<double>(L, -1, "error");
      if (!(*sampling.error > 0)) throw InputError("shadow.truth: error is over 0");
    } else {
      throw InputError(
          fmt::format("shadow.truth has no option {}{}", key, did_you_mean(key, names)));
    }
    lua_pop(L, 1);
  }
  return sampling;
}

int truth_texture(lua_State* L) {
  SceneBox& scene = read_box<SceneBox>(L, 1, "argument 1 of shadow.truth");
  const auto camera = read_box<CameraBox>(L, 2, "argument 2 of shadow.truth").camera();
  const auto light = read_light(L, 3, "argument 3 of shadow.truth (the light)");
  Stage::of(L).truths->push(L, scene, camera, light, read_sampling(L, 4));
  return 1;
}

constexpr Entry functions[] = {
    {"truth",
     "shadow.truth(scene, camera, light, {samples = , pattern = , seed = , error = }) -> texture",
     "The exact, ray-traced visibility at each pixel, in [0, 1], as a gl.R32F texture of the "
     "picture's size: texelFetch it at gl_FragCoord.",
     guarded<truth_texture>},
};

}  // namespace

const truth::Tracer& TruthPool::tracer(const SceneBox& scene) {
  if (!tracer_ || traced_.lock() != scene) {
    tracer_ = std::make_unique<truth::Tracer>(*scene);
    traced_ = scene;
  }
  return *tracer_;
}

void TruthPool::fill(Texture& entry) {
  const int width = entry.size.x, height = entry.size.y;
  const auto scene = entry.scene.lock();
  const image::FloatImage visibility =
      tracer(scene).visibility(entry.camera, entry.light, width, height, entry.sampling);
  // GL's first row is the lowest.
  std::vector<float> rows(visibility.values.size());
  const auto row = static_cast<std::size_t>(width);
  for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y) {
    std::copy_n(visibility.values.begin() + static_cast<std::ptrdiff_t>(y * row), row,
                rows.begin() +
                    static_cast<std::ptrdiff_t>((static_cast<std::size_t>(height) - 1 - y) * row));
  }
  const gl::Functions& gl = stage_.graphics.gl;
  const gl::Untraced untraced(stage_.graphics.calls());
  GLint bound = 0;
  gl.GetIntegerv(GL_TEXTURE_BINDING_2D, {&bound, 1});
  gl.BindTexture(GL_TEXTURE_2D, entry.name);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_R32F, width, height, 0, GL_RED, GL_FLOAT,
                std::as_bytes(std::span(rows)));
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
  gl.BindTexture(GL_TEXTURE_2D, static_cast<GLuint>(bound));
  entry.filled = true;
}

void TruthPool::push(lua_State* L, const SceneBox& scene, const scene::Camera& camera,
                     const scene::Light& light, const truth::Sampling& sampling) {
  if (used_ == textures_.size()) {
    Texture entry;
    std::array<GLuint, 1> name{};
    stage_.graphics.gl.GenTextures.unrecorded(1, name);
    entry.name = name[0];
    push_object(stage_, L, gl::ObjectType::texture, name[0]);
    entry.value = luaL_ref(L, LUA_REGISTRYINDEX);
    textures_.push_back(entry);
  }
  Texture& entry = textures_[used_++];
  const bool known = entry.filled && entry.scene.lock() == scene && same(entry.camera, camera) &&
                     same(entry.light, light) && same(entry.sampling, sampling) &&
                     entry.size == stage_.picture_size();
  if (!known) {
    entry.scene = scene;
    entry.camera = camera;
    entry.light = light;
    entry.sampling = sampling;
    entry.size = stage_.picture_size();
    fill(entry);
  }
  lua_rawgeti(L, LUA_REGISTRYINDEX, entry.value);
}

std::span<const Entry> truth_functions() { return functions; }

void open_truth(Stage& stage) { stage.truths = std::make_shared<TruthPool>(stage); }

}  // namespace shadowlab::lua
