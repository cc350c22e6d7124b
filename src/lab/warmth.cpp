#include "lab/warmth.h"

#include <array>
#include <set>
#include <vector>

#include "core/error.h"
#include "recipe/recipe.h"

namespace shadowlab::lab {
namespace {

struct Operations {
  GLenum fail = GL_KEEP, depth_fail = GL_KEEP, pass = GL_KEEP;
};

// What of the state llvmpipe compiles into a fragment shader.
struct State {
  GLenum depth = GL_LESS;  // 0: no test
  bool writes_depth = true, writes_color = true;
  GLenum stencil = 0;  // 0: no test
  GLuint mask = 0xFF;
  Operations front = {}, back = {};
  GLenum source = 0, destination = 0;  // 0: no blending
};

// Those of the lectures' listings: marking, counting and what is drawn where the stencil lets it.
std::vector<State> states_of_the_lectures() {
  std::vector<State> states{
      {},
      {.depth = GL_LEQUAL},
      {.depth = 0},
      {.depth = GL_LEQUAL, .writes_depth = false},
      {.writes_color = false},
      {.depth = 0, .source = GL_SRC_ALPHA, .destination = GL_ONE_MINUS_SRC_ALPHA},
      {.source = GL_SRC_ALPHA, .destination = GL_ONE_MINUS_SRC_ALPHA},
      {.depth = GL_LEQUAL, .source = GL_ONE, .destination = GL_ONE},
  };
  for (const GLuint mask : {0x01u, 0xFFu}) {
    const Operations replace{.pass = GL_REPLACE}, zero{.pass = GL_ZERO};
    states.push_back({.stencil = GL_ALWAYS, .mask = mask, .front = replace, .back = replace});
    for (const GLenum test : {GL_EQUAL, GL_NOTEQUAL}) {
      for (const GLenum depth : {GL_LESS, GL_LEQUAL})
        states.push_back({.depth = depth, .stencil = test, .mask = mask});
    }
    states.push_back({.depth = 0,
                      .writes_color = false,
                      .stencil = GL_EQUAL,
                      .mask = mask,
                      .front = zero,
                      .back = zero});
  }
  const Operations up{.pass = GL_INCR_WRAP}, down{.pass = GL_DECR_WRAP};
  const Operations fail_up{.depth_fail = GL_INCR_WRAP}, fail_down{.depth_fail = GL_DECR_WRAP};
  using Faces = std::array<Operations, 2>;
  for (const GLuint mask : {0x00u, 0xFFu}) {
    for (const auto& [front, back] :
         {Faces{up, up}, Faces{down, down}, Faces{up, down}, Faces{fail_up, fail_up},
          Faces{fail_down, fail_down}, Faces{fail_down, fail_up}}) {
      states.push_back({.writes_depth = false,
                        .writes_color = false,
                        .stencil = GL_ALWAYS,
                        .mask = mask,
                        .front = front,
                        .back = back});
    }
  }
  return states;
}

void set(const gl::Functions& gl, GLenum capability, bool on) {
  on ? gl.Enable(capability) : gl.Disable(capability);
}

void set(const gl::Functions& gl, const State& state) {
  set(gl, GL_DEPTH_TEST, state.depth != 0);
  if (state.depth != 0) gl.DepthFunc(state.depth);
  gl.DepthMask(state.writes_depth ? GL_TRUE : GL_FALSE);
  const GLboolean color = state.writes_color ? GL_TRUE : GL_FALSE;
  gl.ColorMask(color, color, color, color);
  set(gl, GL_STENCIL_TEST, state.stencil != 0);
  if (state.stencil != 0) {
    gl.StencilFunc(state.stencil, 1, state.mask);
    gl.StencilOpSeparate(GL_FRONT, state.front.fail, state.front.depth_fail, state.front.pass);
    gl.StencilOpSeparate(GL_BACK, state.back.fail, state.back.depth_fail, state.back.pass);
  }
  set(gl, GL_BLEND, state.source != 0);
  if (state.source != 0) gl.BlendFunc(state.source, state.destination);
}

// Makes the first draw into each framebuffer with each program and under each state too. What it
// leaves set spoils the rest of the frame, which nobody looks at.
class UnderEachState : private gl::DrawObserver {
 public:
  explicit UnderEachState(gl::Graphics& graphics) : graphics_(graphics) {
    graphics_.calls().draws = this;
  }
  ~UnderEachState() override { graphics_.calls().draws = nullptr; }
  UnderEachState(const UnderEachState&) = delete;
  UnderEachState& operator=(const UnderEachState&) = delete;

 private:
  GLint integer(GLenum name) const {
    GLint value = 0;
    graphics_.gl.GetIntegerv(name, {&value, 1});
    return value;
  }

  void before_draw(const std::function<void()>& draw) override {
    if (!framebuffers_.insert(integer(GL_DRAW_FRAMEBUFFER_BINDING)).second) return;
    const auto in_use = static_cast<GLuint>(integer(GL_CURRENT_PROGRAM));
    graphics_.programs.each([&](const gl::Program& program) {
      graphics_.gl.UseProgram(program.name());
      for (const State& state : states_) {
        set(graphics_.gl, state);
        draw();
      }
    });
    graphics_.gl.UseProgram(in_use);
  }

  gl::Graphics& graphics_;
  const std::vector<State> states_ = states_of_the_lectures();
  std::set<GLint> framebuffers_;
};

void draw(gl::Graphics& graphics, const std::filesystem::path& file, Warmth warmth) {
  recipe::Recipe recipe(graphics, file);
  recipe.draw();
  (void)graphics.frame.read_color();
  (void)graphics.frame.read_depth();
  (void)graphics.frame.read_stencil();
  if (warmth == Warmth::recipes) return;
  const UnderEachState under(graphics);
  recipe.draw();
}

}  // namespace

void warm_up(gl::Graphics& graphics, std::span<const std::filesystem::path> recipes,
             Warmth warmth) {
  for (const auto& file : recipes) {
    try {
      draw(graphics, file, warmth);
    } catch (const InputError&) {
      // It is then not warm, and nothing else.
    }
  }
  graphics.begin_frame();
  graphics.clear_buffers();
}

}  // namespace shadowlab::lab
