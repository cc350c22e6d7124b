// The exact visibility as textures, traced again only when scene, camera or light changed.
#pragma once

#include <memory>
#include <vector>

#include "lua/boxes.h"
#include "truth/tracer.h"

namespace shadowlab::lua {

class TruthPool {
 public:
  explicit TruthPool(Stage& stage) : stage_(stage) {}

  void begin_frame() { used_ = 0; }

  /// Pushes the texture (R32F, of the picture's size, visibility in red) for the frame's next
  /// question.
  void push(lua_State* L, const SceneBox& scene, const scene::Camera& camera,
            const scene::Light& light, const truth::Sampling& sampling);

 private:
  struct Texture {
    std::weak_ptr<scene::Scene> scene;
    scene::Camera camera;
    scene::Light light;
    truth::Sampling sampling;
    glm::ivec2 size{0};
    int value = LUA_NOREF;  ///< the Lua value, in the registry
    GLuint name = 0;
    bool filled = false;
  };
  void fill(Texture& texture);
  const truth::Tracer& tracer(const SceneBox& scene);

  Stage& stage_;
  std::vector<Texture> textures_;
  std::size_t used_ = 0;
  std::weak_ptr<scene::Scene> traced_;
  std::unique_ptr<truth::Tracer> tracer_;
};

std::span<const Entry> truth_functions();
void open_truth(Stage& stage);

}  // namespace shadowlab::lua
