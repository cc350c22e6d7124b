// Drawing: matrices multiplied in double, handed to the shader as floats.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <limits>

#include "lua/boxes.h"

namespace shadowlab::lua {
namespace {

void set_derived(gl::Shader& shader, std::string_view name, const double* values,
                 std::size_t count) {
  if (const gl::Uniform* uniform = shader.program().find(name))
    shader.set(*uniform, {values, count});
}

template <class T>
T read_field(lua_State* L, int table, const char* name, const T& otherwise) {
  lua_getfield(L, table, name);
  const T value = lua_isnil(L, -1) ? otherwise : read<T>(L, -1, name);
  lua_pop(L, 1);
  return value;
}

// The reserved names of a draw's table; all others are uniforms.
bool reserved(std::string_view name) {
  return name == "view" || name == "projection" || name == "model" || name == "light";
}

template <class T>
bool append_value(lua_State* L, std::vector<double>& numbers) {
  const T* value = test<T>(L, -1);
  if (!value) return false;
  const double* first = glm::value_ptr(*value);
  numbers.insert(numbers.end(), first, first + sizeof(T) / sizeof(double));
  return true;
}

// An element of an array: what is on top of the stack, as its numbers.
bool append_numbers(lua_State* L, std::vector<double>& numbers) {
  if (lua_type(L, -1) == LUA_TNUMBER) {
    numbers.push_back(lua_tonumber(L, -1));
    return true;
  }
  return append_value<glm::dvec2>(L, numbers) || append_value<glm::dvec3>(L, numbers) ||
         append_value<glm::dvec4>(L, numbers) || append_value<glm::dmat3>(L, numbers) ||
         append_value<glm::dmat4>(L, numbers);
}

void set_given(lua_State* L, gl::Shader& shader, int table) {
  lua_pushnil(L);
  while (lua_next(L, table)) {
    if (lua_type(L, -2) != LUA_TSTRING) {
      throw InputError("a draw's table has uniforms by name; " + describe(L, -2) + " is no name");
    }
    std::size_t length = 0;
    const char* name = lua_tolstring(L, -2, &length);
    if (!reserved({name, length})) set_uniform(L, shader, {name, length}, lua_gettop(L));
    lua_pop(L, 1);
  }
}

}  // namespace

void set_uniform(lua_State* L, gl::Shader& shader, std::string_view name, int index) {
  const gl::Uniform* uniform = shader.program().find(name);
  if (!uniform) {
    if (shader.program().declares(name)) return;  // the driver dropped it: it changes nothing
    std::vector<std::string_view> names(shader.program().declared().begin(),
                                        shader.program().declared().end());
    throw InputError(
        fmt::format("the shader declares no uniform {}{}", name, did_you_mean(name, names)));
  }
  const auto set = [&](const auto& value) {
    const auto all = std::span(glm::value_ptr(value), sizeof(value) / sizeof(double));
    shader.set(*uniform, all);
  };
  if (lua_type(L, index) == LUA_TNUMBER) {
    const double number = lua_tonumber(L, index);
    shader.set(*uniform, {&number, 1});
  } else if (lua_isboolean(L, index)) {
    const double number = lua_toboolean(L, index);
    shader.set(*uniform, {&number, 1});
  } else if (const auto* v2 = test<glm::dvec2>(L, index)) {
    set(*v2);
  } else if (const auto* v3 = test<glm::dvec3>(L, index)) {
    set(*v3);
  } else if (const auto* v4 = test<glm::dvec4>(L, index)) {
    set(*v4);
  } else if (const auto* m3 = test<glm::dmat3>(L, index)) {
    set(*m3);
  } else if (const auto* m4 = test<glm::dmat4>(L, index)) {
    set(*m4);
  } else if (lua_type(L, index) == LUA_TTABLE) {
    std::vector<double> numbers;
    const auto count = static_cast<lua_Integer>(std::min<std::size_t>(lua_rawlen(L, index), 4096));
    for (lua_Integer i = 1; i <= count; ++i) {
      lua_rawgeti(L, index, i);
      if (!append_numbers(L, numbers)) {
        throw InputError(
            fmt::format("uniform {} takes numbers, vectors or matrices; element {} is {}", name, i,
                        describe(L, -1)));
      }
      lua_pop(L, 1);
    }
    shader.set(*uniform, numbers);
  } else {
    throw InputError(fmt::format("uniform {} takes numbers, a vector or a matrix; it is {}", name,
                                 describe(L, index)));
  }
}

void draw(const DrawCall& call, const MeshBox& mesh, const glm::dmat4& model,
          const scene::Material& material, std::string_view name) {
  const gl::MeshBuffers& buffers = Stage::of(call.L).graphics.meshes.get(mesh);
  draw_with(call, model, material, mesh->indices.size(), {}, name, [&] { buffers.draw(); });
}

void draw_with(const DrawCall& call, const glm::dmat4& own_model, const scene::Material& material,
               std::size_t indices, std::span<const Derived> derived, std::string_view name,
               const std::function<void()>& draw_elements) {
  lua_State* L = call.L;
  Stage& stage = Stage::of(L);
  gl::Shader& shader = *read_box<ShaderBox>(L, call.shader, "what a draw is given first");
  glm::dmat4 view(1), projection(1), model = own_model;
  std::optional<glm::dvec4> light;
  const bool table = lua_type(L, call.uniforms) == LUA_TTABLE;
  if (!table && !lua_isnoneornil(L, call.uniforms)) {
    throw InputError("what a draw is given second must be a table of uniforms; it is " +
                     describe(L, call.uniforms));
  }
  if (table) {
    view = read_field(L, call.uniforms, "view", view);
    projection = read_field(L, call.uniforms, "projection", projection);
    model = read_field(L, call.uniforms, "model", model);
    lua_getfield(L, call.uniforms, "light");
    if (!lua_isnil(L, -1)) light = read_light(L, lua_gettop(L), "light").position;
    lua_pop(L, 1);
  }
  const glm::dmat4 model_view = view * model;
  const glm::dmat4 model_view_projection = projection * model_view;
  set_derived(shader, "model_view", glm::value_ptr(model_view), 16);
  set_derived(shader, "model_view_projection", glm::value_ptr(model_view_projection), 16);
  set_derived(shader, "projection", glm::value_ptr(projection), 16);
  set_derived(shader, "view", glm::value_ptr(view), 16);
  set_derived(shader, "model", glm::value_ptr(model), 16);
  if (shader.program().find("normal_matrix")) {
    // A shadow matrix flattens: it has no inverse, and its shader no use for normals.
    const glm::dmat3 linear(model_view);
    const glm::dmat3 inverse = glm::inverseTranspose(linear);
    const auto numbers = std::span(glm::value_ptr(inverse), 9);
    const bool usable = std::all_of(numbers.begin(), numbers.end(), [](double number) {
      return std::abs(number) <= std::numeric_limits<float>::max();
    });
    set_derived(shader, "normal_matrix", glm::value_ptr(usable ? inverse : linear), 9);
  }
  if (light) {
    const glm::dvec4 in_eye_space = view * *light;
    set_derived(shader, "light", glm::value_ptr(in_eye_space), 4);
  }
  set_derived(shader, "color", glm::value_ptr(material.color), 3);
  for (const Derived& uniform : derived) {
    set_derived(shader, uniform.name(), uniform.components().data(), uniform.components().size());
  }
  if (table) set_given(L, shader, call.uniforms);

  stage.state.check_budget(indices);
  shader.use();
  draw_elements();
  if (gl::Recorder* recorder = stage.graphics.recorder()) recorder->comment(name);
  stage.graphics.vertices.bind_array(0);
  if (const GLenum error = stage.graphics.gl.GetError.pointer(); error != GL_NO_ERROR) {
    throw InputError(fmt::format(
        "drawing {}: {}", name,
        error == GL_INVALID_FRAMEBUFFER_OPERATION
            ? fmt::format(
                  "the framebuffer is not complete (gl.{})",
                  gl::name_of<gl::FramebufferStatus>(
                      stage.graphics.gl.CheckFramebufferStatus.unrecorded(GL_DRAW_FRAMEBUFFER)))
            : fmt::format("GL reports GL_{}", gl::name_of<gl::ErrorCode>(error))));
  }
}

}  // namespace shadowlab::lua
