#include <fmt/format.h>

#include <cctype>
#include <map>

#include "docs/gl_reference.h"
#include "docs/printers.h"
#include "lua/modules.h"

namespace shadowlab::docs {
namespace {

// The first function of each part of functions.def.
const std::map<std::string_view, std::string_view> parts{
    {"ClearColor", "The whole framebuffer"},
    {"Enable", "Tests and operations on fragments"},
    {"Viewport", "Rasterization"},
    {"GenTextures", "Textures"},
    {"GenFramebuffers", "Framebuffers"},
    {"GenBuffers", "Vertices"},
    {"CreateShader", "Programs"},
    {"GenQueries", "Queries and state"},
};

// The heading's name in a link: GitHub's rule for one word.
std::string anchor(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

std::string linked(const Argument& argument) {
  if (argument.value_list.empty()) return argument.words;
  std::string words = argument.words;
  const std::size_t at = words.find(argument.value_list);
  if (at == std::string::npos) return words;
  return words.replace(at, argument.value_list.size(),
                       fmt::format("[{}](#{})", argument.value_list, anchor(argument.value_list)));
}

bool mentions(const std::string& signature, const std::string& name) {
  const std::string_view text(signature);
  const std::string_view inside = text.substr(text.find('('));
  for (std::size_t at = inside.find(name); at != std::string_view::npos;
       at = inside.find(name, at + 1)) {
    const auto part_of_word = [&](std::size_t i) {
      return std::isalnum(static_cast<unsigned char>(inside[i])) != 0;
    };
    if (!part_of_word(at - 1) && !part_of_word(at + name.size())) return true;
  }
  return false;
}

std::string line_of(const GlFunction& function) {
  std::string text = "- `" + function.signature;
  if (!function.by_hand && !function.result.words.empty()) text += " -> " + function.result.words;
  text += "`";
  std::string arguments, words;
  for (const Argument& argument : function.arguments) {
    // A signature by hand shows what it takes in place of tables and texts.
    if (function.by_hand &&
        (argument.value_list.empty() || !mentions(function.signature, argument.name)))
      continue;
    if (argument.words == argument.name) continue;  // "texture: texture" says nothing
    // "red, green, blue, alpha: number": what they take once for all of them.
    if (!arguments.empty()) arguments += linked(argument) == words ? ", " : ": " + words + "; ";
    words = linked(argument);
    arguments += argument.name;
  }
  if (!arguments.empty()) arguments = " — " + arguments + ": " + words;
  return text + arguments + "\n";
}

std::string gl_part() {
  std::string text =
      "## gl\n\n"
      "`gl.StencilFunc(gl.ALWAYS, 1, 0xFF)` is `glStencilFunc(GL_ALWAYS, 1, 0xFF)`: the same "
      "name,\n"
      "arguments, order and meaning (OpenGL 4.5 core profile specification; `Accum` and "
      "`ClearAccum`,\n"
      "OpenGL 2.1). Where C writes through a pointer, Lua returns; where C takes an array, Lua "
      "takes a\n"
      "table. Objects are values of their own, never integers; 0 is none, and the main frame for\n"
      "framebuffers. Wrong arguments are refused with the function, the argument, what it takes "
      "and\n"
      "the nearest name.\n";
  for (const GlFunction& function : gl_functions()) {
    const auto part = parts.find(function.name);
    if (part != parts.end()) text += fmt::format("\n### {}\n\n", part->second);
    text += line_of(function);
  }
  text += "\n## Values\n\nThe constants that each kind of argument takes.\n";
  for (const ValueList& list : value_lists()) {
    text += fmt::format("\n### {}\n\n", list.name);
    if (list.bits) text += "Any of these, joined by `|`.\n\n";
    std::string names;
    for (const gl::Constant& value : list.values)
      names += fmt::format("{}`gl.{}`", names.empty() ? "" : ", ", value.name);
    text += names + "\n";
  }
  return text;
}

std::string entries(std::span<const lua::Entry> list) {
  std::string text;
  for (const lua::Entry& entry : list)
    text += fmt::format("- `{}` — {}\n", entry.signature, entry.text);
  return text;
}

std::string module_parts() {
  std::string text;
  std::string_view before;
  for (const lua::Module& module : lua::all_modules()) {
    if (module.name != before) text += fmt::format("\n## {}\n", module.name);
    before = module.name;
    if (*module.text) text += fmt::format("\n{}\n", module.text);
    text += "\n" + entries(module.entries);
  }
  return text;
}

std::string value_parts() {
  std::string text =
      "\n## What the modules give\n\n"
      "Their values can be read and drawn, never changed; reading a name that they lack is an "
      "error.\n";
  for (const lua::ValueType& type : lua::all_values()) {
    text += fmt::format("\n### {}\n\n{}\n\n", type.name, type.text) + entries(type.methods);
    for (const lua::Field& field : type.fields)
      text += fmt::format("- `.{}` — {}\n", field.name, field.text);
  }
  return text;
}

}  // namespace

std::string reference() {
  return "# What a recipe can call\n\n"
         "<!-- Generated by lua_api from the tables that the bindings are made from: do not edit. "
         "-->\n\n"
         "A first recipe is in [student.md](student.md). For an editor that knows these names, "
         "open\n[shadowlab.lua](shadowlab.lua) as a library of the Lua language server.\n\n" +
         gl_part() + module_parts() + value_parts();
}

}  // namespace shadowlab::docs
