// Annotations of the Lua language server (LuaLS, "Annotations").
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>

#include "docs/gl_reference.h"
#include "docs/printers.h"
#include "docs/signature.h"
#include "lua/modules.h"

namespace shadowlab::docs {
namespace {

std::string function_text(const std::string& callee, const std::vector<std::string>& arguments) {
  return fmt::format("function {}({}) end\n\n", callee, fmt::join(arguments, ", "));
}

std::string results_text(const std::vector<std::string>& results) {
  std::string text;
  for (const std::string& result : results) text += "---@return " + result + "\n";
  return text;
}

std::string gl_function(const GlFunction& function) {
  const Signature signature = parse(function.signature);
  std::string text = fmt::format("---`{}`\n", function.signature);
  for (const std::string& name : signature.arguments) {
    std::string type = "any";
    for (const Argument& argument : function.arguments) {
      if (argument.name == name) type = argument.type;
    }
    text += fmt::format("---@param {} {}\n", name, type);
  }
  if (function.by_hand) {
    text += results_text(signature.results);
  } else if (!function.result.type.empty()) {
    text += "---@return " + function.result.type + "\n";
  }
  return text + function_text(signature.callee, signature.arguments);
}

std::string gl_text() {
  std::string text = "---@class gl\ngl = {}\n\n";
  for (const gl::Constant& constant : gl::all_constants())
    text += fmt::format("gl.{} = 0x{:04X}\n", constant.name, constant.value);
  text += "\n";
  std::set<std::string> objects;
  for (const GlFunction& function : gl_functions()) {
    for (const Argument& argument : function.arguments) {
      if (argument.type.starts_with("gl.") && argument.value_list.empty())
        objects.insert(argument.type);
    }
  }
  for (const std::string& object : objects) text += fmt::format("---@class {}\n", object);
  for (const ValueList& list : value_lists()) {
    text += fmt::format("\n---@alias gl.{}\n", list.name);
    if (list.bits) text += "---| integer\n";
    for (const gl::Constant& value : list.values) text += fmt::format("---| `gl.{}`\n", value.name);
  }
  text += "\n";
  for (const GlFunction& function : gl_functions()) text += gl_function(function);
  return text;
}

// A function under the name that its module or its value has in the stub.
std::string entry_text(const lua::Entry& entry, const std::string& owner) {
  const Signature signature = parse(entry.signature);
  std::string callee = owner.empty() ? signature.callee : owner;
  if (!owner.empty()) {
    const bool of_a_value = signature.callee.find(':') != std::string::npos;
    callee += (of_a_value ? ":" : ".") + std::string(entry.name);
  }
  auto results = signature.results;
  if (results.empty()) results.push_back("any");
  return fmt::format("---{}\n---\n---`{}`\n", entry.text, entry.signature) + results_text(results) +
         function_text(callee, signature.arguments);
}

// vec2 … quat: the module is what makes the values, and holds their methods.
bool is_arithmetic(const lua::Module& module) {
  const std::string_view name = module.name;
  return name.starts_with("vec") || name.starts_with("mat") || name == "quat";
}

std::string arithmetic_class(const lua::Module& module) {
  const std::string name = module.name;
  std::string text =
      fmt::format("---{}\n---@class {}\n---@overload fun(...: any): {}\n", module.text, name, name);
  for (const char* operation : {"add", "sub", "div", "unm"})
    text += fmt::format("---@operator {}{}: {}\n", operation,
                        std::string_view(operation) == "unm" ? "" : "(any)", name);
  text += fmt::format("---@operator mul(any): {}\n", name.starts_with("vec") ? name : "any");
  return text + fmt::format("---@field [any] any\n{} = {{}}\n\n", name);
}

std::string modules_text() {
  std::string text;
  std::string_view before;
  for (const lua::Module& module : lua::all_modules()) {
    const bool of_one = std::string_view(module.name) == "pass";  // functions, not a table
    const bool first = module.name != before;
    before = module.name;
    if (is_arithmetic(module)) {
      text += arithmetic_class(module);
    } else if (first && !of_one) {
      text += fmt::format("---{}\n{} = {{}}\n\n", module.text, module.name);
    }
    for (const lua::Entry& entry : module.entries) {
      if (!entry.is_metamethod()) text += entry_text(entry, of_one ? "" : module.name);
    }
  }
  return text;
}

std::string values_text() {
  std::string text;
  for (const lua::ValueType& type : lua::all_values()) {
    text += fmt::format("---{}\n---@class {}\n", type.text, type.name);
    for (const lua::Field& field : type.fields)
      text += fmt::format("---@field {} any {}\n", field.name, field.text);
    text += fmt::format("local {} = {{}}\n\n", type.name + std::string("_value"));
    for (const lua::Entry& entry : type.methods)
      text += entry_text(entry, type.name + std::string("_value"));
  }
  return text;
}

}  // namespace

std::string stub() {
  return "---@meta\n"
         "-- Generated by lua_api --stub from the tables that the bindings are made from: do not "
         "edit.\n"
         "-- For the Lua language server: name this file's folder in workspace.library.\n\n" +
         gl_text() + modules_text() + values_text();
}

}  // namespace shadowlab::docs
