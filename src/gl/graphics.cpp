#include "gl/graphics.h"

#include <utility>

#include "gl/state.h"

namespace shadowlab::gl {
namespace {

Functions loaded(const context::Context& context, const CallContext* calls) {
  Functions functions;
  functions.load([&](const char* name) { return context.function(name); },
                 context.major * 10 + context.minor, calls);
  return functions;
}

}  // namespace

Graphics::Graphics(context::Context context, int width, int height)
    : context_(std::move(context)),
      gl(loaded(context_, &calls_)),
      frame(gl, calls_, width, height),
      programs(gl),
      accumulation(gl, calls_, frame, programs),
      meshes(gl, calls_) {
  begin_frame();
  clear_buffers();
}

Graphics::~Graphics() { context_.make_current(); }

void Graphics::begin_frame() {
  context_.make_current();
  const Untraced untraced(calls_);
  reset_state(gl, frame.width(), frame.height());
  for (const GLuint program : std::exchange(deleted_in_use_, {}))
    gl.DeleteProgram.unrecorded(program);
  vertices.unbind();
  accumulation.begin_frame();
  meshes.sweep();
  std::erase_if(shaders_, [](const std::weak_ptr<Shader>& shader) { return shader.expired(); });
  for (const auto& weak : shaders_) {
    if (const auto shader = weak.lock()) shader->begin_frame();
  }
}

std::shared_ptr<Shader> Graphics::make_shader(const ProgramSource& source) {
  auto shader = std::make_shared<Shader>(programs.get(source));
  shaders_.push_back(shader);
  return shader;
}

void Graphics::keep_uniforms() {
  for (const auto& weak : shaders_) {
    if (const auto shader = weak.lock()) shader->keep_values();
  }
}

void Graphics::forget(Objects& objects) {
  begin_frame();
  objects.clear(gl, vertices);
}

void Graphics::delete_when_unused(GLuint program) {
  GLint used = 0;
  gl.GetIntegerv.unrecorded(GL_CURRENT_PROGRAM, {&used, 1});
  if (static_cast<GLuint>(used) == program) {
    deleted_in_use_.push_back(program);
  } else {
    gl.DeleteProgram.unrecorded(program);
  }
}

void Graphics::resize(int width, int height) {
  begin_frame();
  frame.resize(width, height);
  begin_frame();
  clear_buffers();
}

void Graphics::clear_buffers() {
  const Untraced untraced(calls_);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  accumulation.release();
}

}  // namespace shadowlab::gl
