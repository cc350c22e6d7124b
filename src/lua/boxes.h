// The C++ values that recipes hold, beside vectors, matrices and GL objects.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gl/program.h"
#include "lua/box.h"
#include "lua/stage.h"
#include "scene/scene.h"

namespace shadowlab::lua {

using ShaderBox = std::shared_ptr<gl::Shader>;
using MeshBox = std::shared_ptr<const scene::Mesh>;
using SceneBox = std::shared_ptr<scene::Scene>;

struct CameraBox {
  SceneBox scene;
  const scene::Camera& camera() const { return scene->camera; }
};

/// One object of a scene.
struct ObjectBox {
  SceneBox scene;
  std::size_t index;
  const scene::Object& object() const { return scene->objects[index]; }
};

/// All objects of a role: scene.caster, scene.receiver.
struct GroupBox {
  SceneBox scene;
  scene::Role role;
  bool has(const scene::Object& object) const {
    return role == scene::Role::caster ? object.casts() : object.receives();
  }
};

/// A recipe's parameter: what it is, its default and its range.
struct Parameter {
  enum class Kind { point, direction, number, integer, choice, toggle, color };
  Kind kind = Kind::number;
  std::vector<double> value;         ///< 3 numbers; 1; or the 0-based index of a choice
  double least = 0, most = 0;        ///< of numbers and integers
  std::vector<std::string> choices;  ///< of a choice
};

/// "point", "number" …
const char* name_of(Parameter::Kind kind);

template <class T>
struct NoFields {
  static bool push_field(lua_State*, T&, std::string_view) { return false; }
  static std::span<const std::string_view> fields() { return {}; }
};
template <>
struct BoxTraits<ShaderBox> : NoFields<ShaderBox> {
  static constexpr const char* name = "shader";
};
template <>
struct BoxTraits<MeshBox> {
  static constexpr const char* name = "mesh";
  static bool push_field(lua_State*, MeshBox&, std::string_view);
  static std::span<const std::string_view> fields();
};
template <>
struct BoxTraits<SceneBox> {
  static constexpr const char* name = "scene";
  static bool push_field(lua_State*, SceneBox&, std::string_view);
  static std::span<const std::string_view> fields();
};
template <>
struct BoxTraits<CameraBox> {
  static constexpr const char* name = "camera";
  static bool push_field(lua_State*, CameraBox&, std::string_view);
  static std::span<const std::string_view> fields();
};
template <>
struct BoxTraits<ObjectBox> {
  static constexpr const char* name = "object";
  static bool push_field(lua_State*, ObjectBox&, std::string_view);
  static std::span<const std::string_view> fields();
};
template <>
struct BoxTraits<GroupBox> : NoFields<GroupBox> {
  static constexpr const char* name = "group of objects";
};
template <>
struct BoxTraits<Parameter> : NoFields<Parameter> {
  static constexpr const char* name = "parameter";
};

/// Pushes the parameter's value as a recipe's r.params has it: a vec4 (w = 1 for a point, 0 for a
/// direction), a number, a boolean, a string, a vec3 for a colour.
void push_value(lua_State* L, const Parameter& parameter);

/// Sets the value from a text, as --set gives it: "2,4,1", "0.5", "true", a choice's name. Throws
/// InputError that says what the parameter takes.
void set_value(Parameter& parameter, const std::string& name, const std::string& text);

/// The value as set_value takes it, without loss: "2,4,1", "0.5", "true", a choice's name.
std::string text_of(const Parameter& parameter);

/// A light at `index`: a vec4, a table of 4 numbers, or an area light { center = , u = , v = }
/// (rectangle), { center = , u = , v = , disk = true } or { center = , radius = } (sphere).
scene::Light read_light(lua_State* L, int index, const char* what);
inline scene::Light read_light(lua_State* L, int index, const std::string& what) {
  return read_light(L, index, what.c_str());
}
void push_light(lua_State* L, const scene::Light& light);

/// A mesh that counts against the state's memory.
MeshBox hold(State& state, scene::Mesh mesh);

/// How a thing is drawn: with this shader, and the table of view, projection, light, model and
/// uniforms at `uniforms` (or nil). `model` and `material` are the thing's own.
struct DrawCall {
  lua_State* L;
  int shader;
  int uniforms;
};
void draw(const DrawCall& call, const MeshBox& mesh, const glm::dmat4& model,
          const scene::Material& material, std::string_view name);

/// A uniform that the core derives; set where the shader declares it.
class Derived {
 public:
  /// At most four components.
  Derived(const char* name, std::initializer_list<double> components)
      : name_(name), count_(components.size()) {
    std::copy(components.begin(), components.end(), components_.begin());
  }
  const char* name() const { return name_; }
  std::span<const double> components() const { return {components_.data(), count_}; }

 private:
  const char* name_;
  std::array<double, 4> components_{};
  std::size_t count_;
};

/// The same for anything that is drawn by `draw_elements`, `indices` of them.
void draw_with(const DrawCall& call, const glm::dmat4& model, const scene::Material& material,
               std::size_t indices, std::span<const Derived> derived, std::string_view name,
               const std::function<void()>& draw_elements);

/// Sets one uniform of `shader` from the Lua value at `index`: a number, a boolean, a vector, a
/// matrix, a table of numbers. Throws InputError for a name that no stage declares.
void set_uniform(lua_State* L, gl::Shader& shader, std::string_view name, int index);

}  // namespace shadowlab::lua
