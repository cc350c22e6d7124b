#include "cli/beginnings.h"

#include <fmt/format.h>

namespace shadowlab::cli {
namespace {

constexpr std::string_view recipe_text = R"lua(-- Drawn by: shadowlab run {file}
local recipe = {{
  title  = "{title}",
  scene  = "table",                    -- shadowlab list scenes
  params = {{
    light    = param.point(2, 4, 1),   -- --set light=1,3,2
    darkness = param.number(0.4, 0, 1),
  }},
}}

-- Once, before the first frame; r carries what it makes.
function recipe.setup(r)
  r.phong = shader.load "phong"
  r.flat = shader.load "flat"
end

-- Every frame.
function recipe.draw(r)
  local scene, light = r.scene, r.params.light
  local view, projection = scene.camera:view(), scene.camera:projection(r.width / r.height)
  local receiver = scene.receivers[1]

  gl.ClearColor(0.85, 0.88, 0.92, 1)
  gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT)
  gl.Enable(gl.DEPTH_TEST)

  pass("1. the receiver", function()
    receiver:draw(r.phong, {{ view = view, projection = projection, light = light }})
  end)

  -- Flat on the receiver's plane, so without a depth test. Where it reaches past the receiver it is
  -- wrong: the stencil buffer can clip it.
  pass("2. the projected caster", function()
    gl.Disable(gl.DEPTH_TEST)
    local onto_plane = shadow.planar(receiver.plane, light)
    for _, caster in ipairs(scene.casters) do
      caster:draw(r.flat, {{ view = view, projection = projection, model = onto_plane * caster.model,
                            color = vec3(0.3) * r.params.darkness }})
    end
    gl.Enable(gl.DEPTH_TEST)
  end)

  pass("3. the caster", function()
    scene.caster:draw(r.phong, {{ view = view, projection = projection, light = light }})
  end)
end

return recipe
)lua";

constexpr std::string_view projection = "local onto_plane = shadow.planar(receiver.plane, light)";
constexpr std::string_view gap =
    "local onto_plane = mat4.scale(0)   -- here: the matrix that projects onto receiver.plane";

constexpr std::string_view manifest_text = R"lua(return {{
  title  = "{title}",
  points = 10,
  size   = {{ 256, 256 }},
  scene  = "table",
  cases  = {{
    {{ name = "light of the exercise", points = 4, set = {{ light = {{ 2, 4, 1 }} }} }},
    {{ name = "light and camera elsewhere", points = 6, hidden = true,
      set = {{ light = random.point({{ -2, 3, -2 }}, {{ 2, 5, 2 }}) }},
      camera = random.camera {{ around = {{ 0, 0.2, 0 }}, distance = {{ 5.5, 7.5 }},
                               elevation = {{ 25, 55 }}, fovy = 40 }} }},
  }},
}}
)lua";

constexpr std::string_view readme_text = R"md(# {title}

**Goal.** The shadow of the caster on the receiver.

**Theory.** A matrix projects every point onto the receiver's plane, along lines through the light.

**What to fill in.** In pass 2 of `template.lua`, the matrix `onto_plane`.

**Try it.** `shadowlab run template.lua --set light=2,4,1`

**Common errors.** Matrices act from right to left.
)md";

std::string replaced(std::string text, std::string_view old, std::string_view by) {
  return text.replace(text.find(old), old.size(), by);
}

}  // namespace

std::string recipe_to_begin_with(const std::string& file, const std::string& title) {
  return fmt::format(recipe_text, fmt::arg("file", file), fmt::arg("title", title));
}

std::vector<std::pair<std::string, std::string>> lab_to_begin_with(const std::string& title) {
  const std::string solution = recipe_to_begin_with("solution.lua", title);
  return {
      {"lab.lua", fmt::format(manifest_text, fmt::arg("title", title))},
      {"solution.lua", solution},
      {"template.lua",
       "-- floor: 0\n" + replaced(recipe_to_begin_with("template.lua", title), projection, gap)},
      {"mistakes/matrices_swapped.lua",
       "-- hint: The caster is projected first and moved afterwards: matrices act from right to "
       "left.\n" +
           replaced(solution, "onto_plane * caster.model", "caster.model * onto_plane")},
      {"README.md", fmt::format(readme_text, fmt::arg("title", title))},
  };
}

}  // namespace shadowlab::cli
