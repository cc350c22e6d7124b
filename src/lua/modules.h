// What a recipe can call, for the reference in docs/ and for editors: every module's functions, and
// the values that they give.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "lua/entry.h"

namespace shadowlab::lua {

/// A field of a value: v.name.
struct Field {
  std::string_view name;
  std::string_view text;
};

/// What a module's functions give: its methods, and what can be read of it.
struct ValueType {
  const char* name;  ///< "shader"
  const char* text;
  std::span<const Entry> methods;
  std::vector<Field> fields;
};

/// Every module but gl, whose functions are gl::function_descriptions(): vec2 … quat, shader, mesh,
/// scene, shadow, fbo, pass, param.
std::vector<Module> all_modules();

/// The values with methods and fields, beside vec2 … quat, whose modules hold theirs.
std::vector<ValueType> all_values();

std::span<const Entry> shader_functions();
std::span<const Entry> shader_methods();
std::span<const Entry> mesh_functions();
std::span<const Entry> mesh_methods();
std::span<const Entry> scene_functions();
std::span<const Entry> scene_methods();
std::span<const Entry> object_methods();
std::span<const Entry> camera_methods();
std::span<const Entry> shadow_functions();
std::span<const Entry> map_functions();
std::span<const Entry> cascade_functions();
std::span<const Entry> triangle_grid_functions();
std::span<const Entry> plan_functions();
std::span<const Entry> volume_functions();
std::span<const Entry> volume_methods();
std::span<const Entry> truth_functions();
std::span<const Entry> fbo_functions();
std::span<const Entry> pass_functions();
std::span<const Entry> param_functions();

}  // namespace shadowlab::lua
