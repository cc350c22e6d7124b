#include "gl/functions.h"

#include <fmt/format.h>

#include "core/error.h"
#include "gl/c_text.h"

namespace shadowlab::gl {
namespace {

using Formatter = std::string (*)(std::uint64_t, std::span<const std::byte>);

template <class... Kinds>
struct Formatters {
  static constexpr std::array<Formatter, sizeof...(Kinds) + 1> list{&as_c<Kinds>..., nullptr};
};

constexpr std::size_t parameter_count(std::string_view names) {
  if (names.empty()) return 0;
  std::size_t count = 1;
  for (const char c : names) count += c == ',';
  return count;
}

#define SHADOWLAB_GL_DESCRIBE(use, result, name, parameters, ...)                \
  static_assert(parameter_count(parameters) == decltype(Functions::name)::arity, \
                "the names and the kinds of the parameters of " #name " differ in number");
#define SHADOWLAB_GL(...) SHADOWLAB_GL_DESCRIBE(plain, __VA_ARGS__)
#define SHADOWLAB_GL_OWN(...) SHADOWLAB_GL_DESCRIBE(own, __VA_ARGS__)
#define SHADOWLAB_GL_CORE(...) SHADOWLAB_GL_DESCRIBE(core, __VA_ARGS__)
#include "gl/functions.def"
#undef SHADOWLAB_GL_DESCRIBE

#define SHADOWLAB_GL_DESCRIBE(use, result, name, parameters, ...) \
  FunctionDescription{#name,                                      \
                      "gl" #name,                                 \
                      parameters,                                 \
                      FunctionDescription::Use::use,              \
                      #result,                                    \
                      #__VA_ARGS__,                               \
                      Formatters<__VA_ARGS__>::list.data(),       \
                      decltype(Functions::name)::arity},

constexpr auto descriptions = std::to_array<FunctionDescription>({
#include "gl/functions.def"
});
#undef SHADOWLAB_GL
#undef SHADOWLAB_GL_OWN
#undef SHADOWLAB_GL_CORE
#undef SHADOWLAB_GL_DESCRIBE

// Newer than OpenGL 3.3, or the core's own: a context may do without them.
bool optional(std::string_view name) {
  static constexpr std::string_view names[] = {
      "Accum",        "ClearAccum",         "ClipControl",    "BindTextureUnit",
      "BlendFunci",   "BlendFuncSeparatei", "BlendEquationi", "BlendEquationSeparatei",
      "TexStorage2D", "TexStorage3D"};
  if (name.starts_with("Create") && name != "CreateShader" && name != "CreateProgram") return true;
  if (name.find("Named") != std::string_view::npos) return true;
  if (name.starts_with("Texture") || name == "CopyTextureSubImage2D") return true;
  for (const auto other : names) {
    if (name == other) return true;
  }
  return false;
}

}  // namespace

void Functions::load(const std::function<void (*(const char*))()>& loader, int version,
                     const CallContext* context) {
#define SHADOWLAB_GL(result, function, ...)                                                  \
  function.shared = context;                                                                 \
  if (version >= 45 || !optional(#function)) {                                               \
    function.pointer = reinterpret_cast<decltype(function.pointer)>(loader("gl" #function)); \
    if (!function.pointer && !optional(#function)) {                                         \
      throw MachineError("This GL context has no gl" #function                               \
                         "; shadowlab needs OpenGL 3.3 (run `shadowlab doctor`).");          \
    }                                                                                        \
  }
#define SHADOWLAB_GL_OWN SHADOWLAB_GL
#define SHADOWLAB_GL_CORE SHADOWLAB_GL
#include "gl/functions.def"
#undef SHADOWLAB_GL
#undef SHADOWLAB_GL_OWN
#undef SHADOWLAB_GL_CORE
}

std::span<const FunctionDescription> function_descriptions() { return descriptions; }

const FunctionDescription& describe(FunctionId id) {
  return descriptions[static_cast<std::size_t>(id)];
}

std::string_view parameter_name(const FunctionDescription& function, std::size_t index) {
  if (index >= function.arity) return {};
  std::string_view names = function.parameters;
  for (; index > 0; --index) names.remove_prefix(names.find(", ") + 2);
  return names.substr(0, names.find(','));
}

}  // namespace shadowlab::gl
