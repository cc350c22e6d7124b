#include "gl/under_each_state.h"

#include <array>

#include "gl/get.h"

namespace shadowlab::gl {

// What the stencil does on each outcome of the tests.
struct Operations {
  GLenum fail = GL_KEEP, depth_fail = GL_KEEP, pass = GL_KEEP;
};

struct CompiledState {
  GLenum depth = GL_LESS;  // 0: no test
  bool writes_depth = true, writes_color = true;
  GLenum stencil = 0;  // 0: no test
  GLuint mask = 0xFF;
  Operations front = {}, back = {};
  GLenum source = 0, destination = 0;  // 0: no blending
};

namespace {

// Those of the lectures' listings: marking, counting and what is drawn where the stencil lets it.
std::vector<CompiledState> states_of_the_lectures() {
  std::vector<CompiledState> states{
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

void set(const Functions& gl, GLenum capability, bool on) {
  on ? gl.Enable(capability) : gl.Disable(capability);
}

void set(const Functions& gl, const CompiledState& state) {
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

}  // namespace

UnderEachState::UnderEachState(Graphics& graphics)
    : graphics_(graphics), states_(states_of_the_lectures()) {
  graphics_.calls().draws = this;
}

UnderEachState::~UnderEachState() { graphics_.calls().draws = nullptr; }

void UnderEachState::before_draw(const std::function<void()>& draw) {
  if (!framebuffers_.insert(integer(graphics_.gl, GL_DRAW_FRAMEBUFFER_BINDING)).second) return;
  const auto in_use = static_cast<GLuint>(integer(graphics_.gl, GL_CURRENT_PROGRAM));
  graphics_.programs.each([&](const Program& program) {
    graphics_.gl.UseProgram(program.name());
    // What leaves its traces in the stencil alone is drawn without light, by a shader that takes a
    // third of the time to compile.
    const bool lights = program.declares("light");
    for (const CompiledState& state : states_) {
      if (lights && state.stencil != 0 && !state.writes_color) continue;
      set(graphics_.gl, state);
      draw();
    }
  });
  graphics_.gl.UseProgram(in_use);
}

}  // namespace shadowlab::gl
