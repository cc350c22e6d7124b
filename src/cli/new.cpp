// shadowlab new: a recipe to begin with.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "cli/commands.h"
#include "cli/files.h"
#include "core/error.h"

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

// "my_shadow" becomes "My shadow".
std::string title_of(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
  return name;
}

void expect_name(const std::string& name, const std::string& given) {
  const bool good = !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-';
  });
  if (!good)
    throw InputError(fmt::format("\"{}\" is no name: names have letters, digits, _ and -", given));
}

void new_recipe(const std::string& given) {
  std::filesystem::path file(given);
  if (file.extension() == ".lua") file.replace_extension();
  const std::string name = file.filename().string();
  expect_name(name, given);
  file += ".lua";
  std::error_code none;
  if (std::filesystem::exists(file, none))
    throw InputError(file.string() + " exists already; choose another name");
  expect_writable(file);
  write_text(
      file,
      fmt::format(recipe_text, fmt::arg("file", file.string()), fmt::arg("title", title_of(name))),
      Existing::refuse);
  fmt::print("{} is a recipe; draw it: shadowlab run {}\n", file.string(), file.string());
}

}  // namespace

void add_new(CLI::App& app, Answer& answer) {
  CLI::App* command = app.add_subcommand("new", "Write a recipe to begin with");
  struct Options {
    std::string what, name;
  };
  auto options = std::make_shared<Options>();
  command->add_option("what", options->what, "recipe")
      ->required()
      ->check(one_of({"recipe", "lab"}))
      ->type_name("recipe|lab");
  command->add_option("name", options->name, "Its name; NAME.lua must not exist")
      ->required()
      ->type_name("NAME");
  command->footer("Example:\n  shadowlab new recipe my_shadow && shadowlab run my_shadow.lua");
  command->callback([options, &answer] {
    if (options->what == "lab")
      throw InputError("labs are not there yet: this version of shadowlab makes recipes only");
    new_recipe(options->name);
    answer = Answer::yes;
  });
}

}  // namespace shadowlab::cli
