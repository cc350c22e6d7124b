// scene: the catalogue of scripts/scenes, objects by role, the camera, the lights.
#include <fmt/format.h>

#include <algorithm>

#include "lua/boxes.h"
#include "lua/planned.h"

namespace shadowlab::lua {
namespace {

// ---- reading a scene file's table, which is on top of the stack

template <class T>
T field(lua_State* L, int table, const char* name, const std::string& what, const T& otherwise) {
  lua_getfield(L, table, name);
  const T value = lua_isnil(L, -1) ? otherwise : read<T>(L, -1, (what + "." + name).c_str());
  lua_pop(L, 1);
  return value;
}

std::string text_field(lua_State* L, int table, const char* name) {
  lua_getfield(L, table, name);
  std::string text = lua_type(L, -1) == LUA_TSTRING ? lua_tostring(L, -1) : "";
  lua_pop(L, 1);
  return text;
}

scene::Camera read_camera(lua_State* L, int table) {
  scene::Camera camera;
  camera.eye = field(L, table, "eye", "camera", camera.eye);
  camera.target = field(L, table, "target", "camera", camera.target);
  camera.up = field(L, table, "up", "camera", camera.up);
  camera.fovy = field(L, table, "fovy", "camera", camera.fovy);
  camera.near = field(L, table, "near", "camera", camera.near);
  camera.far = field(L, table, "far", "camera", camera.far);
  camera.view();  // refuse here, with the scene's name, what no recipe could use
  camera.projection(1);
  return camera;
}

scene::Role read_role(lua_State* L, int table, const std::string& what) {
  const std::string role = text_field(L, table, "role");
  if (role == "caster") return scene::Role::caster;
  if (role == "receiver") return scene::Role::receiver;
  if (role == "both" || role.empty()) return scene::Role::both;
  throw InputError(
      fmt::format("{}.role is \"caster\", \"receiver\" or \"both\", not \"{}\"", what, role));
}

scene::Object read_object(lua_State* L, int table, const std::string& what) {
  scene::Object object;
  object.name = text_field(L, table, "name");
  if (object.name.empty()) object.name = what;
  lua_getfield(L, table, "mesh");
  object.mesh = read_box<MeshBox>(L, -1, what + ".mesh");
  lua_pop(L, 1);
  object.model = field(L, table, "model", what, object.model);
  object.material.color = field(L, table, "color", what, object.material.color);
  object.role = read_role(L, table, what);
  return object;
}

scene::Scene read_scene(lua_State* L, const std::string& name) {
  const int table = lua_gettop(L);
  if (lua_type(L, table) != LUA_TTABLE) {
    throw InputError(
        fmt::format("scene {} must return a table; it returns {}", name, describe(L, table)));
  }
  scene::Scene scene;
  scene.name = name;
  scene.title = text_field(L, table, "title");
  if (lua_getfield(L, table, "camera") == LUA_TTABLE) scene.camera = read_camera(L, lua_gettop(L));
  lua_pop(L, 1);
  if (lua_getfield(L, table, "lights") == LUA_TTABLE) {
    for (lua_Integer i = 1; lua_rawgeti(L, -1, i) != LUA_TNIL; ++i) {
      scene.lights.push_back(read_light(L, lua_gettop(L), fmt::format("lights[{}]", i)));
      lua_pop(L, 1);
    }
    lua_pop(L, 1);
  }
  lua_pop(L, 1);
  if (lua_getfield(L, table, "objects") != LUA_TTABLE) {
    throw InputError(
        fmt::format("scene {}: objects must be a table; it is {}", name, describe(L, -1)));
  }
  for (lua_Integer i = 1; lua_rawgeti(L, -1, i) == LUA_TTABLE; ++i) {
    scene.objects.push_back(read_object(L, lua_gettop(L), fmt::format("objects[{}]", i)));
    lua_pop(L, 1);
  }
  lua_settop(L, table);
  if (scene.objects.empty()) throw InputError(fmt::format("scene {} has no objects", name));
  return scene;
}

std::filesystem::path scene_file(const Stage& stage, const std::string& name) {
  const auto of_a_name = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
  };
  if (name.empty() || !std::all_of(name.begin(), name.end(), of_a_name)) {
    throw InputError(
        fmt::format("\"{}\" is no scene's name; names have letters, digits and _", name));
  }
  try {
    return find_file(stage, "scenes/" + name + ".lua");
  } catch (const InputError&) {
    std::vector<std::string> found;
    for (const auto& folder : stage.folders) {
      std::error_code error;
      for (const auto& entry : std::filesystem::directory_iterator(folder / "scenes", error)) {
        if (entry.path().extension() == ".lua") found.push_back(entry.path().stem().string());
      }
    }
    std::sort(found.begin(), found.end());
    const std::vector<std::string_view> names(found.begin(), found.end());
    throw InputError(fmt::format("there is no scene {}{}", name, did_you_mean(name, names)));
  }
}

int load(lua_State* L) {
  if (lua_type(L, 1) != LUA_TSTRING)
    throw InputError("scene.load takes the name of a scene; it is " + describe(L, 1));
  const std::string name = lua_tostring(L, 1);
  Stage& stage = Stage::of(L);
  const auto file = scene_file(stage, name).lexically_proximate(std::filesystem::current_path());
  if (const auto problem = stage.state.try_load_file(L, file)) throw InputError(*problem);
  lua_call(L, 0, 1);
  push_box<SceneBox>(L, std::make_shared<scene::Scene>(read_scene(L, name)));
  return 1;
}

// ---- a scene's parts

void draw_one(lua_State* L, const SceneBox& scene, std::size_t index) {
  if (!is_needed(L, 3, scene, index)) return;
  const scene::Object& object = scene->objects[index];
  draw({L, 2, 3}, object.mesh, object.model, object.material, object.name);
}

int draw_scene(lua_State* L) {
  SceneBox& scene = read_box<SceneBox>(L, 1, "scene:draw: self");
  for (std::size_t i = 0; i < scene->objects.size(); ++i) draw_one(L, scene, i);
  return 0;
}

int find_object(lua_State* L) {
  SceneBox& scene = read_box<SceneBox>(L, 1, "scene:object: self");
  const std::string name = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : describe(L, 2);
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < scene->objects.size(); ++i) {
    names.push_back(scene->objects[i].name);
    if (scene->objects[i].name == name) {
      push_box<ObjectBox>(L, {scene, i});
      return 1;
    }
  }
  throw InputError(
      fmt::format("scene {} has no object {}{}", scene->name, name, did_you_mean(name, names)));
}

int draw_group(lua_State* L) {
  GroupBox& group = read_box<GroupBox>(L, 1, "draw: self");
  for (std::size_t i = 0; i < group.scene->objects.size(); ++i) {
    if (group.has(group.scene->objects[i])) draw_one(L, group.scene, i);
  }
  return 0;
}

int draw_object(lua_State* L) {
  const ObjectBox& object = read_box<ObjectBox>(L, 1, "object:draw: self");
  draw_one(L, object.scene, object.index);
  return 0;
}

int view(lua_State* L) {
  push(L, read_box<CameraBox>(L, 1, "camera:view: self").camera().view());
  return 1;
}

int projection(lua_State* L) {
  const auto& camera = read_box<CameraBox>(L, 1, "camera:projection: self").camera();
  const double aspect = lua_isnoneornil(L, 2)
                            ? Stage::of(L).aspect()
                            : read<double>(L, 2, "argument 1 of camera:projection");
  push(L, camera.projection(aspect));
  return 1;
}

int moved(lua_State* L) {
  const CameraBox& box = read_box<CameraBox>(L, 1, "camera:moved: self");
  const auto by = read<glm::dvec3>(L, 2, "argument 1 of camera:moved");
  // A scene of its own around it, whose objects share their meshes with the first.
  auto scene = std::make_shared<scene::Scene>(*box.scene);
  scene->camera.eye += by;
  scene->camera.target += by;
  push_box<CameraBox>(L, {std::move(scene)});
  return 1;
}

constexpr Entry functions[] = {
    {"load", "scene.load(name) -> scene",
     "A scene of the catalogue: scenes/name.lua beside the recipe or in scripts/.", guarded<load>},
};
constexpr Entry scene_entries[] = {
    {"draw", "s:draw(shader, uniforms)", "Draws every object.", guarded<draw_scene>},
    {"object", "s:object(name) -> object", "The object of that name.", guarded<find_object>},
};
constexpr Entry group_entries[] = {
    {"draw", "s.caster:draw(shader, uniforms), s.receiver:draw(…)",
     "Draws every caster, or every receiver.", guarded<draw_group>},
};
constexpr Entry object_entries[] = {
    {"draw", "o:draw(shader, uniforms)",
     "Draws the object with its own model matrix and colour, unless the uniforms give others.",
     guarded<draw_object>},
};
constexpr Entry camera_entries[] = {
    {"view", "c:view() -> mat4", "World to eye space.", guarded<view>},
    {"projection", "c:projection(aspect) -> mat4",
     "Eye to clip space; aspect is width / height, of the picture unless given.",
     guarded<projection>},
    {"moved", "c:moved(vec3) -> camera", "The same camera with eye and target moved, world space.",
     guarded<moved>},
};

constexpr std::string_view scene_fields[] = {"name",    "title",     "camera", "lights",  "objects",
                                             "casters", "receivers", "caster", "receiver"};
constexpr std::string_view object_fields[] = {"name", "mesh", "model", "color", "role", "plane"};
constexpr std::string_view camera_fields[] = {"eye", "target", "up", "fovy", "near", "far"};

template <class Keep>
void push_objects(lua_State* L, const SceneBox& scene, Keep keep) {
  lua_newtable(L);
  lua_Integer next = 0;
  for (std::size_t i = 0; i < scene->objects.size(); ++i) {
    if (!keep(scene->objects[i])) continue;
    push_box<ObjectBox>(L, {scene, i});
    lua_rawseti(L, -2, ++next);
  }
}

}  // namespace

bool BoxTraits<SceneBox>::push_field(lua_State* L, SceneBox& scene, std::string_view key) {
  if (key == "name" || key == "title") {
    lua_pushstring(L, (key == "name" ? scene->name : scene->title).c_str());
  } else if (key == "camera") {
    push_box<CameraBox>(L, {scene});
  } else if (key == "caster" || key == "receiver") {
    push_box<GroupBox>(L, {scene, key == "caster" ? scene::Role::caster : scene::Role::receiver});
  } else if (key == "objects") {
    push_objects(L, scene, [](const scene::Object&) { return true; });
  } else if (key == "casters") {
    push_objects(L, scene, [](const scene::Object& object) { return object.casts(); });
  } else if (key == "receivers") {
    push_objects(L, scene, [](const scene::Object& object) { return object.receives(); });
  } else if (key == "lights") {
    lua_newtable(L);
    for (std::size_t i = 0; i < scene->lights.size(); ++i) {
      push_light(L, scene->lights[i]);
      lua_rawseti(L, -2, static_cast<lua_Integer>(i) + 1);
    }
  } else {
    return false;
  }
  return true;
}

std::span<const std::string_view> BoxTraits<SceneBox>::fields() { return scene_fields; }

bool BoxTraits<ObjectBox>::push_field(lua_State* L, ObjectBox& box, std::string_view key) {
  const scene::Object& object = box.object();
  if (key == "name") {
    lua_pushstring(L, object.name.c_str());
  } else if (key == "mesh") {
    push_box<MeshBox>(L, object.mesh);
  } else if (key == "model") {
    push(L, object.model);
  } else if (key == "color") {
    push(L, object.material.color);
  } else if (key == "role") {
    lua_pushstring(L, object.role == scene::Role::caster     ? "caster"
                      : object.role == scene::Role::receiver ? "receiver"
                                                             : "both");
  } else if (key == "plane") {
    const auto plane = scene::plane_of(*object.mesh, object.model);
    if (!plane)
      throw InputError(fmt::format("object {} is not planar, so it has no plane", object.name));
    push(L, *plane);
  } else {
    return false;
  }
  return true;
}

std::span<const std::string_view> BoxTraits<ObjectBox>::fields() { return object_fields; }

bool BoxTraits<CameraBox>::push_field(lua_State* L, CameraBox& box, std::string_view key) {
  const scene::Camera& camera = box.camera();
  if (key == "eye" || key == "target" || key == "up") {
    push(L, key == "eye" ? camera.eye : key == "target" ? camera.target : camera.up);
  } else if (key == "fovy" || key == "near" || key == "far") {
    lua_pushnumber(L, key == "fovy" ? camera.fovy : key == "near" ? camera.near : camera.far);
  } else {
    return false;
  }
  return true;
}

std::span<const std::string_view> BoxTraits<CameraBox>::fields() { return camera_fields; }

std::span<const Entry> scene_functions() { return functions; }
std::span<const Entry> scene_methods() { return scene_entries; }
std::span<const Entry> object_methods() { return object_entries; }
std::span<const Entry> camera_methods() { return camera_entries; }

void open_scene(Stage& stage) {
  lua_State* L = stage.state.raw();
  open_box<SceneBox>(L, scene_entries);
  open_box<GroupBox>(L, group_entries);
  open_box<ObjectBox>(L, object_entries);
  open_box<CameraBox>(L, camera_entries);
  lua_newtable(L);
  set_functions(L, functions);
  refuse_unknown_names(L, -1, "scene");
  lua_setglobal(L, "scene");
}

}  // namespace shadowlab::lua
