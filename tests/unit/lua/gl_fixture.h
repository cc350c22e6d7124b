// Scripts that call GL, in a state of their own over one context for the whole program.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "core/error.h"
#include "core/version.h"
#include "gl/graphics.h"
#include "lua/guard.h"
#include "lua/object.h"
#include "lua/stage.h"

namespace shadowlab::lua {

inline constexpr int frame_size = 64;

class GlScript : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    graphics_ = std::make_unique<gl::Graphics>(context::create(), frame_size, frame_size);
  }
  static void TearDownTestSuite() { graphics_.reset(); }

  void SetUp() override { start({}); }
  void TearDown() override {
    stop();
    used_ = nullptr;
    graphics().begin_frame();
    EXPECT_EQ(graphics().gl.GetError.pointer(), GLenum{GL_NO_ERROR});
  }

  void start(const Limits& limits) {
    graphics().begin_frame();
    graphics().clear_buffers();
    state_ = std::make_unique<State>(limits, [](std::string_view) {});
    stage_ = std::make_unique<Stage>(
        Stage{*state_, graphics(), nullptr, {}, {home() / "scripts", home() / "shaders"}});
    open_all(*stage_);
  }
  void stop() {
    if (stage_) graphics().forget(stage_->objects);
    state_.reset();
    stage_.reset();
  }

  gl::Graphics& graphics() { return used_ ? *used_ : *graphics_; }
  /// Scripts started from now on draw into this context.
  void use(gl::Graphics& other) {
    stop();
    used_ = &other;
  }
  Stage& stage() { return *stage_; }
  State& state() { return *state_; }

  /// What the chunk returns, as text.
  std::string value(std::string_view text) {
    state().load_text(text, "a.lua");
    state().call(0, 1);
    std::string result(push_text(state().raw(), -1));
    lua_settop(state().raw(), 0);
    return result;
  }
  /// Runs a chunk that returns nothing of interest.
  void run(std::string_view text) { value(text); }

  /// The sentence of the error that the chunk ends with, without its file and line.
  std::string error(std::string_view text) {
    try {
      return "no error, but " + value(text);
    } catch (const InputError& problem) {
      lua_settop(state().raw(), 0);
      const std::string sentence = problem.what();
      EXPECT_TRUE(sentence.starts_with("a.lua:")) << sentence;
      return sentence.substr(std::min(sentence.size(), sentence.find(": ") + 2));
    }
  }

 private:
  static inline std::unique_ptr<gl::Graphics> graphics_;
  gl::Graphics* used_ = nullptr;
  std::unique_ptr<State> state_;
  std::unique_ptr<Stage> stage_;
};

/// A program that fills everything with its uniform `color`, in `program`, in use.
inline constexpr const char* fill_program = R"lua(
  local function stage(kind, text)
    local shader = gl.CreateShader(kind)
    gl.ShaderSource(shader, text)
    gl.CompileShader(shader)
    assert(gl.GetShaderiv(shader, gl.COMPILE_STATUS) == gl.TRUE, gl.GetShaderInfoLog(shader))
    return shader
  end
  program = gl.CreateProgram()
  gl.AttachShader(program, stage(gl.VERTEX_SHADER, [[#version 330 core
    layout(location = 0) in vec4 position;
    void main() { gl_Position = position; }]]))
  gl.AttachShader(program, stage(gl.FRAGMENT_SHADER, [[#version 330 core
    uniform vec4 color;
    out vec4 fragment;
    void main() { fragment = color; }]]))
  gl.LinkProgram(program)
  assert(gl.GetProgramiv(program, gl.LINK_STATUS) == gl.TRUE, gl.GetProgramInfoLog(program))
  gl.UseProgram(program)
)lua";

/// A vertex array of three vec4 that cover the frame, bound, its buffer of 48 bytes in `corners`.
inline constexpr const char* covering_triangle = R"lua(
  vertices, corners = gl.GenVertexArrays(1), gl.GenBuffers(1)
  gl.BindVertexArray(vertices)
  gl.BindBuffer(gl.ARRAY_BUFFER, corners)
  gl.BufferData(gl.ARRAY_BUFFER, 48, {-1,-1,0,1, 3,-1,0,1, -1,3,0,1}, gl.STATIC_DRAW)
  gl.EnableVertexAttribArray(0)
  gl.VertexAttribPointer(0, 4, gl.FLOAT, false, 0, 0)
)lua";

}  // namespace shadowlab::lua
