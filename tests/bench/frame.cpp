// A frame of scripts/projected_stencil.lua at 512² against the same passes written in C++ with the
// same function table, programs and buffers.
//
//   bench_frame
//
// Wall clock, medians of 301 single frames of each, in turns, glFinish at each frame's end. The two
// pictures are compared first: a ratio of different frames would mean nothing.
#include <fmt/format.h>

#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <fstream>

#include "core/version.h"
#include "medians.h"
#include "recipe/recipe.h"
#include "shadow/planar.h"

namespace shadowlab {
namespace {

constexpr int size = 512;

/// The program of shaders/NAME, with the locations of what this frame sets.
class Program {
 public:
  Program(gl::Graphics& graphics, const std::string& name)
      : gl_(graphics.gl),
        shader_(graphics.make_shader({file(name + ".vert"), file(name + ".frag"), {}})) {}

  void use() const { gl_.UseProgram(shader_->program().name()); }
  void set(const char* name, double value) const {
    gl_.Uniform1f(location(name), static_cast<GLfloat>(value));
  }
  void set(const char* name, const glm::vec3& value) const {
    gl_.Uniform3fv(location(name), 1, {glm::value_ptr(value), 3});
  }
  void set(const char* name, const glm::vec4& value) const {
    gl_.Uniform4fv(location(name), 1, {glm::value_ptr(value), 4});
  }
  void set(const char* name, const glm::mat3& value) const {
    gl_.UniformMatrix3fv(location(name), 1, GL_FALSE, {glm::value_ptr(value), 9});
  }
  void set(const char* name, const glm::mat4& value) const {
    gl_.UniformMatrix4fv(location(name), 1, GL_FALSE, {glm::value_ptr(value), 16});
  }

 private:
  static gl::StageSource file(const std::string& name) {
    std::ifstream stream(home() / "shaders" / name);
    return {name, {std::istreambuf_iterator<char>(stream), {}}};
  }
  GLint location(const char* name) const {
    const gl::Uniform* uniform = shader_->program().find(name);
    return uniform ? uniform->location : -1;
  }

  const gl::Functions& gl_;
  std::shared_ptr<gl::Shader> shader_;
};

/// The recipe in C++. Matrices in double, floats only for GL, as the core does.
class InCpp {
 public:
  InCpp(gl::Graphics& graphics, const scene::Scene& scene)
      : graphics_(graphics),
        gl_(graphics.gl),
        scene_(scene),
        phong_(graphics, "phong"),
        planar_(graphics, "planar") {}

  void draw() {
    graphics_.begin_frame();
    view_ = scene_.camera.view();
    projection_ = scene_.camera.projection(1);
    gl_.ClearColor(0.85f, 0.88f, 0.92f, 1);
    gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    gl_.Enable(GL_DEPTH_TEST);
    mark();
    clear_where_shadow_falls();

    gl_.Enable(GL_DEPTH_TEST);
    gl_.DepthFunc(GL_LEQUAL);
    gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl_.StencilFunc(GL_EQUAL, 0, 0xFF);
    gl_.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    for (const scene::Object& object : scene_.objects) {
      if (object.receives()) lit(object, darkness, 0);
    }

    gl_.DepthFunc(GL_LESS);
    gl_.Disable(GL_STENCIL_TEST);
    for (const scene::Object& object : scene_.objects) {
      if (object.casts()) lit(object, 0.25, 1);
    }
  }

 private:
  static constexpr double darkness = 0.35;
  const glm::dvec4 light_{2, 4, 1, 1};

  void mark() {
    gl_.Enable(GL_STENCIL_TEST);
    gl_.StencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    GLint number = 0;
    for (const scene::Object& object : scene_.objects) {
      if (!object.receives()) continue;
      gl_.StencilFunc(GL_ALWAYS, ++number, 0xFF);
      lit(object, darkness, 1);
    }
  }

  void clear_where_shadow_falls() {
    gl_.Disable(GL_DEPTH_TEST);
    gl_.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    gl_.StencilOp(GL_KEEP, GL_KEEP, GL_ZERO);
    gl_.Enable(GL_CLIP_DISTANCE0);
    GLint number = 0;
    for (const scene::Object& receiver : scene_.objects) {
      if (!receiver.receives()) continue;
      gl_.StencilFunc(GL_EQUAL, ++number, 0xFF);
      const glm::dvec4 plane = *scene::plane_of(*receiver.mesh, receiver.model);
      const glm::dmat4 onto_plane = shadow::planar(plane, light_);
      const glm::dvec4 above = shadow::plane_toward(plane, light_);
      for (const scene::Object& caster : scene_.objects) {
        if (!caster.casts()) continue;
        planar_.use();
        planar_.set("model_view_projection",
                    glm::mat4(projection_ * (view_ * (onto_plane * caster.model))));
        planar_.set("above", glm::vec4(glm::transpose(caster.model) * above));
        planar_.set("color", glm::vec3(caster.material.color));
        graphics_.meshes.get(caster.mesh).draw();
      }
    }
    gl_.Disable(GL_CLIP_DISTANCE0);
  }

  void lit(const scene::Object& object, double ambient, double lit) {
    const glm::dmat4 model_view = view_ * object.model;
    phong_.use();
    phong_.set("model_view", glm::mat4(model_view));
    phong_.set("model_view_projection", glm::mat4(projection_ * model_view));
    phong_.set("normal_matrix", glm::mat3(glm::inverseTranspose(glm::dmat3(model_view))));
    phong_.set("light", glm::vec4(view_ * light_));
    phong_.set("color", glm::vec3(object.material.color));
    phong_.set("ambient", ambient);
    phong_.set("lit", lit);
    graphics_.meshes.get(object.mesh).draw();
  }

  gl::Graphics& graphics_;
  const gl::Functions& gl_;
  const scene::Scene& scene_;
  Program phong_, planar_;
  glm::dmat4 view_{1}, projection_{1};
};

}  // namespace
}  // namespace shadowlab

int main(int argc, char** argv) {
  using namespace shadowlab;
  gl::Graphics graphics(context::create(), size, size);
  recipe::Recipe in_lua(graphics, home() / "scripts" / "projected_stencil.lua");
  InCpp in_cpp(graphics, *in_lua.scene());
  in_lua.draw();
  const image::Image picture = graphics.frame.read_color();
  in_cpp.draw();
  if (graphics.frame.read_color() != picture) {
    fmt::print(stderr, "The frame in C++ is not the recipe's: they differ in pixels.\n");
    return 1;
  }
  const auto measure = [&](const char* name, auto& frame) {
    benchmark::RegisterBenchmark(name, [&](benchmark::State& state) {
      for (auto _ : state) {
        frame.draw();
        graphics.gl.Finish.unrecorded();
      }
    })->UseRealTime();
  };
  measure("lua", in_lua);
  measure("cpp", in_cpp);
  bench::Medians medians(bench::Clock::wall);
  bench::run_interleaved(argc, argv, medians, "--benchmark_repetitions=301",
                         "--benchmark_min_time=0.001");
  const double lua = medians.median("lua"), cpp = medians.median("cpp");
  fmt::print(
      "projected_stencil, {0}x{0}, ms a frame: Lua {1:.3f}, C++ {2:.3f}, ratio {3:.3f} "
      "(target 1.05)\n",
      size, lua * 1e3, cpp * 1e3, lua / cpp);
}
