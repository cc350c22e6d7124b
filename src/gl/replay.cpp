#include "gl/replay.h"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>

namespace shadowlab::gl {
namespace {

template <class Kind>
constexpr bool is_name = std::is_base_of_v<EnumKind, Kind>;
template <class Kind>
constexpr bool is_number =
    std::is_same_v<Kind, Int> || std::is_same_v<Kind, Uint> || std::is_same_v<Kind, Mask> ||
    std::is_same_v<Kind, Size> || std::is_same_v<Kind, Float> || std::is_same_v<Kind, Double>;
template <class Kind>
constexpr bool has_text = is_name<Kind> || is_number<Kind> || std::is_same_v<Kind, Bool>;

// What gl/c_text.h prints for a value of the kind.
template <class Kind>
std::optional<CppOf<Kind>> from_c(const std::string& text) {
  if constexpr (is_name<Kind>) {
    for (const Constant& constant : Kind::values) {
      if (text.size() == constant.name.size() + 3 && text.ends_with(constant.name))
        return constant.value;
    }
    return std::nullopt;
  } else if constexpr (std::is_same_v<Kind, Bool>) {
    if (text == "GL_TRUE") return GLboolean{1};
    if (text == "GL_FALSE") return GLboolean{0};
    return std::nullopt;
  } else {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    const bool whole = end != text.c_str() && (*end == '\0' || std::string_view(end) == "f");
    if (!whole || !std::isfinite(value)) return std::nullopt;
    if constexpr (std::is_integral_v<CppOf<Kind>>) {
      using Limits = std::numeric_limits<CppOf<Kind>>;
      if (value < static_cast<double>(Limits::min()) || value > static_cast<double>(Limits::max()))
        return std::nullopt;
    }
    if constexpr (std::is_same_v<Kind, Size>) {
      if (value < 0) return std::nullopt;
    }
    return static_cast<CppOf<Kind>>(value);
  }
}

template <FunctionId Id, class... Kinds, std::size_t... Index>
bool make(const Function<Id, Nothing, Kinds...>& function, std::span<const std::string> texts,
          std::index_sequence<Index...>) {
  const std::tuple<std::optional<CppOf<Kinds>>...> values{from_c<Kinds>(texts[Index])...};
  if (!(std::get<Index>(values).has_value() && ...)) return false;
  function.unrecorded(*std::get<Index>(values)...);
  return true;
}

template <FunctionId Id, class Result, class... Kinds>
bool make(const Function<Id, Result, Kinds...>& function, std::span<const std::string> texts) {
  if constexpr (std::is_same_v<Result, Nothing> && sizeof...(Kinds) > 0 &&
                (has_text<Kinds> && ...)) {
    if (!function || texts.size() != sizeof...(Kinds)) return false;
    return make(function, texts, std::index_sequence_for<Kinds...>());
  } else {
    return false;
  }
}

}  // namespace

bool replay(const Functions& gl, std::string_view c_name, std::span<const std::string> arguments) {
#define SHADOWLAB_GL(result, name, ...) \
  if (c_name == "gl" #name) return make(gl.name, arguments);
#define SHADOWLAB_GL_OWN(...)
#define SHADOWLAB_GL_CORE(...)
#include "gl/functions.def"
#undef SHADOWLAB_GL
#undef SHADOWLAB_GL_OWN
#undef SHADOWLAB_GL_CORE
  return false;
}

}  // namespace shadowlab::gl
