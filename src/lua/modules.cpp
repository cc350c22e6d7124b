#include "lua/modules.h"

#include <stdexcept>
#include <string>

#include "lua/boxes.h"
#include "lua/sampling.h"
#include "lua/volume_pool.h"

namespace shadowlab::lua {
namespace {

// The texts beside the fields that T has: one for each, or the reference would be wrong.
template <class T>
std::vector<Field> described(std::vector<Field> texts) {
  const auto fields = BoxTraits<T>::fields();
  for (const std::string_view field : fields) {
    bool found = false;
    for (const Field& text : texts) found = found || text.name == field;
    if (!found) throw std::logic_error("no text for the field " + std::string(field));
  }
  if (texts.size() != fields.size()) throw std::logic_error("a text for a field that is gone");
  return texts;
}

}  // namespace

std::vector<Module> all_modules() {
  std::vector<Module> modules;
  for (const Module& module : value_modules()) modules.push_back(module);
  modules.push_back({"shader", "Programs, by file or by text.", shader_functions()});
  modules.push_back(
      {"mesh", "Triangles with positions, normals and texture coordinates.", mesh_functions()});
  modules.push_back({"scene", "The catalogue of scripts/scenes.", scene_functions()});
  modules.push_back({"shadow", "The subject, in double precision.", shadow_functions()});
  modules.push_back({"shadow", "Shadow maps.", map_functions()});
  modules.push_back({"shadow", "Several maps for one view.", cascade_functions()});
  modules.push_back({"shadow", "A map of triangles.", triangle_grid_functions()});
  modules.push_back({"shadow", "Shadow volumes.", volume_functions()});
  modules.push_back({"shadow", "Casters as the light sees them.", silhouette_functions()});
  modules.push_back({"shadow", "Shadow volumes made on the GPU.", extrusion_functions()});
  modules.push_back({"shadow", "Shadows on planes by their outline.", outline_functions()});
  modules.push_back({"shadow", "Soft light.", sample_functions()});
  modules.push_back({"shadow", "What a frame needs.", plan_functions()});
  modules.push_back({"shadow", "The exact visibility.", truth_functions()});
  modules.push_back({"fbo",
                     "Short forms for the common targets; gl.GenFramebuffers and its like are the "
                     "long one.",
                     fbo_functions()});
  modules.push_back({"pass", "", pass_functions()});
  modules.push_back({"param",
                     "A recipe's parameters: --set gives them other values, and r.params has them.",
                     param_functions()});
  return modules;
}

std::vector<ValueType> all_values() {
  return {
      {"shader", "What shader.load and shader.compile give.", shader_methods(), {}},
      {"mesh", "What the functions of mesh give.", mesh_methods(),
       described<MeshBox>({{"vertices", "how many there are"},
                           {"triangles", "how many there are"},
                           {"low", "vec3, the least corner of its bounds, model space"},
                           {"high", "vec3, the greatest corner"}})},
      {"scene", "What scene.load gives, and r.scene.", scene_methods(),
       described<SceneBox>({{"name", "as scene.load takes it"},
                            {"title", "a line for people"},
                            {"camera", "a camera"},
                            {"lights",
                             "a table of lights, each a vec4 (w = 0: a direction) or an "
                             "area light's table"},
                            {"objects", "a table of all objects"},
                            {"casters", "a table of the objects that cast shadows"},
                            {"receivers", "a table of the objects that receive them"},
                            {"caster", "all casters as one: s.caster:draw(shader, uniforms)"},
                            {"receiver", "all receivers as one"}})},
      {"object", "One object of a scene.", object_methods(),
       described<ObjectBox>(
           {{"name", "unique within its scene"},
            {"mesh", "a mesh"},
            {"model", "mat4, model to world space"},
            {"color", "vec3, its material's"},
            {"role", "\"caster\", \"receiver\" or \"both\""},
            {"plane", "vec4, world space; refused where the mesh is not planar"}})},
      {"camera", "A scene's camera.", camera_methods(),
       described<CameraBox>({{"eye", "vec3, world space"},
                             {"target", "vec3, world space"},
                             {"up", "vec3, world space"},
                             {"fovy", "the vertical field of view in degrees"},
                             {"near", "the distance of the near plane"},
                             {"far", "the distance of the far plane"}})},
      {"volume", "What shadow.volume gives.", volume_methods(),
       described<VolumeBox>({{"triangles", "how many there are, caps and all"},
                             {"side_triangles", "how many of them are its sides"}})},
      {"outline", "What shadow.outlines gives.", outline_methods(),
       described<Outline>({{"triangles", "how many there are"},
                           {"layers", "no point is counted more often"},
                           {"offset", "to be added to what they count"}})},
      {"extrusion", "What shadow.extrusion gives.", extrusion_methods(),
       described<Extrusion>({{"primitives", "how many the shaders are given"}})},
  };
}

}  // namespace shadowlab::lua
