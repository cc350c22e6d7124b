#include "measure/fill.h"

#include <algorithm>
#include <fstream>
#include <functional>
#include <glm/gtc/type_ptr.hpp>
#include <iterator>

#include "core/clock.h"
#include "core/version.h"
#include "measure/median.h"

namespace shadowlab::measure {
namespace {

constexpr double mpix = 1024 * 1024;

std::shared_ptr<gl::Shader> stock(gl::Graphics& graphics, const std::string& name) {
  const auto stage = [&](const std::string& extension) {
    std::ifstream file(home() / "shaders" / (name + extension));
    return gl::StageSource{name + extension, {std::istreambuf_iterator<char>(file), {}}};
  };
  return graphics.make_shader({stage(".vert"), stage(".frag"), {}});
}

void set(gl::Shader& shader, std::string_view name, std::span<const double> values) {
  if (const gl::Uniform* uniform = shader.program().find(name)) shader.set(*uniform, values);
}

// Draws layers of the whole frame, and takes their time.
class Calibration {
 public:
  explicit Calibration(gl::Graphics& graphics)
      : graphics_(graphics),
        gl_(graphics.gl),
        flat_(stock(graphics, "flat")),
        phong_(stock(graphics, "phong")),
        square_(std::make_shared<scene::Mesh>(scene::quad())),
        cells_(std::make_shared<scene::Mesh>(scene::plane(2, 2, cells, cells))) {
    graphics.begin_frame();
    const glm::dmat4 identity(1);
    const glm::dvec3 normal_rows[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const double light[] = {1, 2, 4, 1}, color[] = {0.8, 0.6, 0.4};
    for (gl::Shader* shader : {flat_.get(), phong_.get()}) {
      set(*shader, "model_view_projection", {glm::value_ptr(identity), 16});
      set(*shader, "model_view", {glm::value_ptr(identity), 16});
      set(*shader, "normal_matrix", {glm::value_ptr(normal_rows[0]), 9});
      set(*shader, "light", light);
      set(*shader, "color", color);
    }
    gl_.Enable(GL_DEPTH_TEST);
    gl_.DepthFunc(GL_ALWAYS);
    gl_.DepthMask(GL_FALSE);
  }

  double layer(Layer kind) {
    const bool colored = kind == Layer::color || kind == Layer::shaded;
    const GLboolean mask = colored ? GL_TRUE : GL_FALSE;
    gl_.ColorMask(mask, mask, mask, mask);
    gl_.DepthMask(kind == Layer::depth ? GL_TRUE : GL_FALSE);
    (kind == Layer::shaded ? phong_ : flat_)->use();
    if (kind == Layer::stencil) {
      gl_.Enable(GL_STENCIL_TEST);
      gl_.StencilFunc(GL_ALWAYS, 0, 0);
      gl_.StencilOp(GL_KEEP, GL_INCR_WRAP, GL_INCR_WRAP);
    } else {
      gl_.Disable(GL_STENCIL_TEST);
    }
    return milliseconds(square_, layers) / frame_mpix();
  }

  // A pass of a single layer, less the layer.
  double pass(double depth_layer) {
    layer(Layer::depth);  // its state
    return std::max(0.0, milliseconds(square_, 1) - depth_layer * frame_mpix());
  }

  // Nanoseconds: a grid of the frame's size, less the pixels that it fills.
  double triangle(double depth_layer) {
    layer(Layer::depth);  // its state
    const glm::dmat4 upright(1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1);
    set(*phong_, "model_view_projection", {glm::value_ptr(upright), 16});
    phong_->use();
    const double filling = depth_layer * frame_mpix();
    return std::max(0.0, milliseconds(cells_, layers) - filling) * 1e6 / (2.0 * cells * cells);
  }

 private:
  static constexpr int cells = 128, layers = 8, repetitions = 15;

  double frame_mpix() const {
    return double(graphics_.width()) * double(graphics_.height()) / mpix;
  }

  // Of one of `draws` draws between two glFinish.
  double milliseconds(const std::shared_ptr<const scene::Mesh>& mesh, int draws) {
    const gl::MeshBuffers& buffers = graphics_.meshes.get(mesh);
    std::vector<double> times;
    for (int i = 0; i < repetitions; ++i) {
      gl_.Finish();
      const double begin = now_ms();
      for (int k = 0; k < draws; ++k) buffers.draw();
      gl_.Finish();
      times.push_back((now_ms() - begin) / draws);
    }
    return median(times);
  }

  gl::Graphics& graphics_;
  const gl::Functions& gl_;
  std::shared_ptr<gl::Shader> flat_, phong_;
  std::shared_ptr<const scene::Mesh> square_, cells_;
};

// Counts what each draw rasterises, by the kind of layer that its state makes it.
class PixelCounter final : public gl::DrawObserver {
 public:
  explicit PixelCounter(gl::Graphics& graphics) : gl_(graphics.gl) {
    gl_.GenQueries(1, {&query_, 1});
  }
  ~PixelCounter() override { gl_.DeleteQueries(1, {&query_, 1}); }

  void before_draw(const std::function<void()>& draw) override {
    std::array<GLboolean, 4> mask{};
    gl_.GetBooleanv.unrecorded(GL_COLOR_WRITEMASK, mask);
    const bool depth = gl_.IsEnabled.unrecorded(GL_DEPTH_TEST) != GL_FALSE;
    const bool stencil = gl_.IsEnabled.unrecorded(GL_STENCIL_TEST) != GL_FALSE;
    const bool colored =
        integer(GL_DRAW_BUFFER0) != GL_NONE &&
        std::any_of(mask.begin(), mask.end(), [](GLboolean on) { return on != 0; });
    const Layer kind = colored   ? lights() ? Layer::shaded : Layer::color
                       : stencil ? Layer::stencil
                                 : Layer::depth;
    gl_.Disable.unrecorded(GL_DEPTH_TEST);
    gl_.Disable.unrecorded(GL_STENCIL_TEST);
    gl_.ColorMask.unrecorded(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    gl_.BeginQuery.unrecorded(GL_SAMPLES_PASSED, query_);
    draw();
    gl_.EndQuery.unrecorded(GL_SAMPLES_PASSED);
    if (depth) gl_.Enable.unrecorded(GL_DEPTH_TEST);
    if (stencil) gl_.Enable.unrecorded(GL_STENCIL_TEST);
    gl_.ColorMask.unrecorded(mask[0], mask[1], mask[2], mask[3]);
    GLuint samples = 0;
    gl_.GetQueryObjectuiv.unrecorded(query_, GL_QUERY_RESULT, {&samples, 1});
    pass_[static_cast<std::size_t>(kind)] += samples / mpix;
  }

  std::array<double, layer_count> take() { return std::exchange(pass_, {}); }

 private:
  GLuint integer(GLenum name) const {
    GLint value = 0;
    gl_.GetIntegerv.unrecorded(name, {&value, 1});
    return static_cast<GLuint>(value);
  }

  // Whether the program in use takes a light: what more it does than phong is the pass's own.
  bool lights() const {
    const GLuint program = integer(GL_CURRENT_PROGRAM);
    return program != 0 && gl_.GetUniformLocation.unrecorded(program, "light") >= 0;
  }

  const gl::Functions& gl_;
  GLuint query_ = 0;
  std::array<double, layer_count> pass_{};
};

}  // namespace

const char* name_of(Layer layer) {
  constexpr std::array<const char*, layer_count> names{"flat colour", "phong", "depth", "stencil"};
  return names[static_cast<std::size_t>(layer)];
}

FillLimit fill_limit(gl::Graphics& graphics) {
  Calibration calibration(graphics);
  FillLimit limit;
  for (std::size_t kind = 0; kind < layer_count; ++kind)
    limit.layer[kind] = calibration.layer(static_cast<Layer>(kind));
  const double depth = limit.layer[static_cast<std::size_t>(Layer::depth)];
  limit.triangle = calibration.triangle(depth);
  limit.pass = calibration.pass(depth);
  return limit;
}

double PassFill::covered() const {
  double all = 0;
  for (const double part : mpix) all += part;
  return all;
}

double PassFill::least(const FillLimit& limit) const {
  double all = 0;
  for (std::size_t kind = 0; kind < layer_count; ++kind) all += mpix[kind] * limit.layer[kind];
  return all;
}

double PassFill::least_in_all(const FillLimit& limit) const {
  return least(limit) + static_cast<double>(triangles) * limit.triangle * 1e-6 +
         static_cast<double>(count) * limit.pass;
}

std::vector<PassFill> count_fill(gl::Graphics& graphics, recipe::Recipe& recipe) {
  PixelCounter counter(graphics);
  std::vector<std::array<double, layer_count>> mpix_of_passes;
  struct Watch {
    gl::Graphics& graphics;
    recipe::Recipe& recipe;
    ~Watch() {
      recipe.on_pass_end({});
      graphics.calls().draws = nullptr;
    }
  } const watch{graphics, recipe};
  graphics.calls().draws = &counter;
  recipe.on_pass_end([&](std::size_t) { mpix_of_passes.push_back(counter.take()); });
  recipe.draw();
  std::vector<PassFill> passes;
  for (std::size_t i = 0; i < mpix_of_passes.size(); ++i) {
    const recipe::PassTime& pass = recipe.passes()[i];
    passes.push_back({pass.name, mpix_of_passes[i], pass.work.triangles, 0});
  }
  return passes;
}

std::vector<PassFill> fill_of(gl::Graphics& graphics, recipe::Recipe& recipe, int frames) {
  recipe.draw();  // what is made once
  std::vector<std::vector<double>> times(recipe.passes().size());
  for (int frame = 0; frame < frames; ++frame) {
    recipe.draw();
    for (std::size_t i = 0; i < times.size(); ++i)
      times[i].push_back(recipe.passes()[i].milliseconds);
  }
  std::vector<PassFill> passes = count_fill(graphics, recipe);
  for (std::size_t i = 0; i < passes.size() && frames > 0; ++i)
    passes[i].milliseconds = median(times[i]);
  return passes;
}

}  // namespace shadowlab::measure
