// shader: programs by file or by text.
#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "lua/boxes.h"

namespace shadowlab::lua {
namespace {

constexpr std::size_t most_source = std::size_t{1} << 20;

std::string whole_text(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string text((std::istreambuf_iterator<char>(stream)), {});
  if (!stream.good() && !stream.eof()) throw InputError("cannot read " + file.string());
  if (text.size() > most_source)
    throw InputError(file.string() + ": a shader's text is at most 1 MiB");
  return text;
}

// The file that a line #include "NAME" names; nothing for any other line.
std::optional<std::string> included_file(std::string_view line) {
  constexpr std::string_view word = "#include \"";
  if (!line.starts_with(word)) return {};
  line.remove_prefix(word.size());
  return std::string(line.substr(0, line.find('"')));
}

struct NamedText {
  std::string name, text;
};

NamedText read_stage(const Stage& stage, const std::string& name) {
  const auto file = find_file(stage, name);
  return {file.lexically_proximate(std::filesystem::current_path()).string(), whole_text(file)};
}

// A stage with its #includes put in, which GLSL itself has not; #line keeps the numbers of lines,
// and source strings from 1 on are the included files. They include nothing themselves.
gl::StageSource with_includes(const Stage& stage, const NamedText& own) {
  gl::StageSource source{own.name, {}, {}};
  int number = 0;
  for (std::string_view rest = own.text; !rest.empty();) {
    const std::size_t end = std::min(rest.find('\n'), rest.size() - 1) + 1;
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(end);
    ++number;
    if (const auto include = included_file(line)) {
      const NamedText part = read_stage(stage, *include);
      source.included.push_back(part.name);
      source.text += fmt::format("#line 1 {}\n{}\n#line {} 0\n", source.included.size(), part.text,
                                 number + 1);
    } else {
      source.text += line;
    }
    if (source.text.size() > most_source)
      throw InputError(own.name + ": a shader's text is at most 1 MiB");
  }
  return source;
}

bool exists(const Stage& stage, const std::string& name) {
  for (const auto& folder : stage.folders) {
    std::error_code error;
    stage.state.note_file(folder / name);
    if (std::filesystem::is_regular_file(folder / name, error)) return true;
  }
  return false;
}

int load(lua_State* L) {
  Stage& stage = Stage::of(L);
  if (lua_type(L, 1) != LUA_TSTRING) {
    throw InputError("shader.load takes the name of a shader, as \"phong\"; it is " +
                     describe(L, 1));
  }
  const std::string name = lua_tostring(L, 1);
  const auto stage_file = [&](const char* ending) {
    return with_includes(stage, read_stage(stage, name + ending));
  };
  gl::ProgramSource source{stage_file(".vert"), stage_file(".frag"), {}};
  if (exists(stage, name + ".geom")) source.geometry = stage_file(".geom");
  push_box<ShaderBox>(L, stage.graphics.make_shader(source));
  return 1;
}

std::optional<gl::StageSource> stage_text(lua_State* L, const char* key) {
  lua_getfield(L, 1, key);
  std::optional<gl::StageSource> source;
  if (lua_type(L, -1) == LUA_TSTRING) {
    std::size_t length = 0;
    const char* text = lua_tolstring(L, -1, &length);
    if (length > most_source) throw InputError("a shader's text is at most 1 MiB");
    source =
        with_includes(Stage::of(L), {fmt::format("{} shader", key), std::string(text, length)});
  } else if (!lua_isnil(L, -1)) {
    throw InputError(
        fmt::format("shader.compile: {} must be a text; it is {}", key, describe(L, -1)));
  }
  lua_pop(L, 1);
  return source;
}

int compile(lua_State* L) {
  Stage& stage = Stage::of(L);
  if (lua_type(L, 1) != LUA_TTABLE) {
    throw InputError("shader.compile takes a table { vertex = text, fragment = text }; it is " +
                     describe(L, 1));
  }
  auto vertex = stage_text(L, "vertex");
  auto fragment = stage_text(L, "fragment");
  if (!vertex || !fragment) throw InputError("shader.compile needs both vertex and fragment");
  const gl::ProgramSource source{std::move(*vertex), std::move(*fragment),
                                 stage_text(L, "geometry")};
  push_box<ShaderBox>(L, stage.graphics.make_shader(source));
  return 1;
}

int use(lua_State* L) {
  ShaderBox& shader = read_box<ShaderBox>(L, 1, "shader:use: self");
  if (lua_type(L, 2) == LUA_TTABLE) {
    lua_pushnil(L);
    while (lua_next(L, 2)) {
      if (lua_type(L, -2) != LUA_TSTRING) throw InputError("shader:use takes uniforms by name");
      set_uniform(L, *shader, lua_tostring(L, -2), lua_gettop(L));
      lua_pop(L, 1);
    }
  } else if (!lua_isnoneornil(L, 2)) {
    throw InputError("shader:use takes a table of uniforms; it is " + describe(L, 2));
  }
  shader->use();
  return 0;
}

int set(lua_State* L) {
  ShaderBox& shader = read_box<ShaderBox>(L, 1, "shader:set: self");
  if (lua_type(L, 2) != LUA_TSTRING)
    throw InputError("shader:set takes the name of a uniform; it is " + describe(L, 2));
  set_uniform(L, *shader, lua_tostring(L, 2), 3);
  return 0;
}

constexpr Entry functions[] = {
    {"load", "shader.load(name) -> shader",
     "The program of name.vert, name.frag and, where there is one, name.geom: beside the recipe, "
     "else shadowlab's own. A line #include \"file\" stands for that file's text.",
     guarded<load>},
    {"compile", "shader.compile{vertex = text, fragment = text, geometry = text} -> shader",
     "The program of these texts, which may #include files too. Errors name the stage and the line "
     "within its text.",
     guarded<compile>},
};
constexpr Entry methods[] = {
    {"use", "s:use{name = value, …}", "Makes it the current program, after setting these uniforms.",
     guarded<use>},
    {"set", "s:set(name, value)",
     "Sets a uniform: a number, a boolean, a vector, a matrix, or a table of numbers. What is set "
     "in setup holds in every frame; what draw sets, to the frame's end.",
     guarded<set>},
};

}  // namespace

std::span<const Entry> shader_functions() { return functions; }
std::span<const Entry> shader_methods() { return methods; }

void open_shader(Stage& stage) {
  lua_State* L = stage.state.raw();
  open_box<ShaderBox>(L, methods);
  lua_newtable(L);
  set_functions(L, functions);
  refuse_unknown_names(L, -1, "shader");
  lua_setglobal(L, "shader");
}

}  // namespace shadowlab::lua
