// Recipes from texts, over one context for the whole program.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <memory>

#include "core/error.h"
#include "core/version.h"
#include "recipe/recipe.h"

namespace shadowlab::recipe {

inline constexpr int frame_size = 64;

/// A recipe's file, in a folder of its own, for as long as this lives.
class RecipeFile {
 public:
  explicit RecipeFile(std::string_view text, const std::string& name = "recipe.lua")
      : folder_(std::filesystem::temp_directory_path() /
                fmt::format("shadowlab-recipe-{}-{}", ::getpid(), next_++)) {
    std::filesystem::create_directory(folder_);
    path_ = folder_ / name;
    std::ofstream(path_) << text;
  }
  ~RecipeFile() { std::filesystem::remove_all(folder_); }
  RecipeFile(const RecipeFile&) = delete;
  RecipeFile& operator=(const RecipeFile&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  static inline int next_ = 0;
  std::filesystem::path folder_;
  std::filesystem::path path_;
};

/// A recipe whose draw is `body`, without a scene.
inline std::string drawing(std::string_view body, std::string_view fields = "") {
  return fmt::format("local recipe = {{ {} }}\nfunction recipe.draw(r) {} end\nreturn recipe\n",
                     fields, body);
}

class RecipeTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    graphics_ = std::make_unique<gl::Graphics>(context::create(), frame_size, frame_size);
  }
  static void TearDownTestSuite() { graphics_.reset(); }

  static gl::Graphics& graphics() { return *graphics_; }

  /// The picture of the recipe's first frame.
  static image::Image picture(std::string_view text, gl::Graphics& graphics = *graphics_) {
    const RecipeFile file(text);
    Recipe recipe(graphics, file.path());
    recipe.draw();
    return graphics.frame.read_color();
  }

  /// What is wrong with it, in making or in drawing its first frame; its file is called F.
  static std::string error(std::string_view text, Options options = {}) {
    const RecipeFile file(text);
    std::string sentence = "no error";
    try {
      Recipe recipe(*graphics_, file.path(), std::move(options));
      recipe.draw();
    } catch (const InputError& problem) {
      sentence = problem.what();
    }
    const std::string name = file.path().string();
    for (std::size_t at; (at = sentence.find(name)) != std::string::npos;)
      sentence.replace(at, name.size(), "F");
    return sentence;
  }

 private:
  static inline std::unique_ptr<gl::Graphics> graphics_;
};

/// A recipe that uses stencil, blending and the accumulation buffer.
inline constexpr const char* stencil_blend_accum = R"lua(
local recipe = { scene = "table" }
function recipe.setup(r) r.phong, r.flat = shader.load "phong", shader.load "flat" end
function recipe.draw(r)
  local camera = r.scene.camera
  local view, projection = camera:view(), camera:projection(1)
  gl.ClearColor(0.2, 0.3, 0.4, 1)
  gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT)
  for i = 1, 3 do
    local light = vec4(i - 2, 4, 1, 1)
    pass("light " .. i, function()
      gl.Enable(gl.DEPTH_TEST)
      gl.DepthFunc(gl.LEQUAL)
      gl.Enable(gl.STENCIL_TEST)
      gl.StencilFunc(gl.ALWAYS, i, 0xFF)
      gl.StencilOp(gl.KEEP, gl.KEEP, gl.REPLACE)
      r.scene:draw(r.phong, { view = view, projection = projection, light = light })
      gl.Enable(gl.BLEND)
      gl.BlendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA)
      gl.StencilFunc(gl.EQUAL, i, 0xFF)
      gl.StencilOp(gl.KEEP, gl.KEEP, gl.INCR)
      r.scene.caster:draw(r.flat, { view = view, projection = projection, alpha = 0.3 })
      gl.Disable(gl.BLEND)
      gl.Disable(gl.STENCIL_TEST)
      gl.Accum(i == 1 and gl.LOAD or gl.ACCUM, 1 / 3)
    end)
  end
  gl.Accum(gl.RETURN, 1)
end
return recipe
)lua";

}  // namespace shadowlab::recipe
