#include "docs/gl_reference.h"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "lua/l_gl.h"

namespace shadowlab::docs {
namespace {

template <class Kind>
struct Words {
  static Argument of() {
    if constexpr (std::is_base_of_v<gl::EnumKind, Kind> || std::is_base_of_v<gl::BitsKind, Kind>) {
      const std::string name(Kind::name);
      return {{}, name, "gl." + name, name};
    } else {
      return {{}, Kind::title, std::string("gl.") + Kind::title, {}};
    }
  }
};

#define SHADOWLAB_WORDS(Kind, words, type)                 \
  template <>                                              \
  struct Words<gl::Kind> {                                 \
    static Argument of() { return {{}, words, type, {}}; } \
  };
SHADOWLAB_WORDS(Int, "integer", "integer")
SHADOWLAB_WORDS(Uint, "integer, not negative", "integer")
SHADOWLAB_WORDS(Mask, "integer of bits", "integer")
SHADOWLAB_WORDS(Size, "integer, not negative", "integer")
SHADOWLAB_WORDS(Float, "number", "number")
SHADOWLAB_WORDS(Double, "number", "number")
SHADOWLAB_WORDS(Bool, "boolean", "boolean")
SHADOWLAB_WORDS(Text, "string", "string")
SHADOWLAB_WORDS(Char, "string", "string")
SHADOWLAB_WORDS(ByteCount, "integer, not negative", "integer")
SHADOWLAB_WORDS(Offset, "offset in bytes", "integer")
SHADOWLAB_WORDS(Nothing, "", "")
SHADOWLAB_WORDS(Bytes, "table of numbers, or string of bytes", "number[]|string")
SHADOWLAB_WORDS(OutBytes, "table of numbers", "number[]")
#undef SHADOWLAB_WORDS

template <>
struct Words<gl::ParameterValue> {
  static Argument of() {
    return {{}, "integer, or TextureParameterValue", "integer", "TextureParameterValue"};
  }
};

template <class Kind>
Argument table_of() {
  Argument element = Words<Kind>::of();
  return {{}, "table of " + element.words, "table", element.value_list};
}
template <class Kind>
struct Words<gl::In<Kind>> {
  static Argument of() { return table_of<Kind>(); }
};
template <class Kind>
struct Words<gl::Out<Kind>> {
  static Argument of() { return table_of<Kind>(); }
};

struct Listed {
  gl::FunctionId id;
  std::vector<Argument> arguments;
  Argument result;
};

template <class Result, class... Kinds>
Listed listed(gl::FunctionId id) {
  Listed function{id, {Words<Kinds>::of()...}, Words<Result>::of()};
  for (std::size_t i = 0; i < function.arguments.size(); ++i)
    function.arguments[i].name = gl::parameter_name(gl::describe(id), i);
  return function;
}

std::vector<Listed> all_listed() {
  using namespace gl;  // functions.def names kinds alone
  return {
#define SHADOWLAB_GL(result, name, parameters, ...) \
  listed<result __VA_OPT__(, ) __VA_ARGS__>(FunctionId::name),
#define SHADOWLAB_GL_OWN SHADOWLAB_GL
#define SHADOWLAB_GL_CORE(...)
#include "gl/functions.def"
#undef SHADOWLAB_GL
#undef SHADOWLAB_GL_OWN
#undef SHADOWLAB_GL_CORE
  };
}

// The kinds that are lists of values, gathered as the functions are gone through.
class ValueLists {
 public:
  template <class Kind>
  void add() {
    if constexpr (std::is_base_of_v<gl::EnumKind, Kind> || std::is_base_of_v<gl::BitsKind, Kind>) {
      const std::string name(Kind::name);
      for (const ValueList& list : lists_) {
        if (list.name == name) return;
      }
      lists_.push_back({name, Kind::values, std::is_base_of_v<gl::BitsKind, Kind>});
    } else if constexpr (std::is_same_v<Kind, gl::ParameterValue>) {
      add<gl::TextureParameterValue>();
    } else if constexpr (!std::is_void_v<typename gl::ElementOf<Kind>::Type>) {
      add<typename gl::ElementOf<Kind>::Type>();
    }
  }
  template <class Result, class... Kinds>
  void add_all() {
    (add<Kinds>(), ...);
    add<Result>();
  }
  std::vector<ValueList> take() { return std::move(lists_); }

 private:
  std::vector<ValueList> lists_;
};

// Nothing that Lua sees as gl.NAME may be missing from the reference.
void expect_all_constants(std::span<const ValueList> lists) {
  for (const gl::Constant& constant : gl::all_constants()) {
    const bool found = std::any_of(lists.begin(), lists.end(), [&](const ValueList& list) {
      return std::any_of(list.values.begin(), list.values.end(),
                         [&](const gl::Constant& value) { return value.name == constant.name; });
    });
    if (!found) throw std::logic_error("in no list of values: " + std::string(constant.name));
  }
}

}  // namespace

std::vector<GlFunction> gl_functions() {
  std::map<gl::FunctionId, const char*> by_hand;
  for (const lua::OwnFunction& own : lua::own_functions()) by_hand[own.function] = own.signature;
  std::vector<GlFunction> functions;
  for (Listed& listed : all_listed()) {
    const gl::FunctionDescription& description = gl::describe(listed.id);
    GlFunction function{std::string(description.name), {}, false, {}, std::move(listed.result)};
    function.arguments = std::move(listed.arguments);
    const auto own = by_hand.find(listed.id);
    function.by_hand = own != by_hand.end() && own->second;
    function.signature =
        function.by_hand ? own->second
                         : "gl." + function.name + "(" + std::string(description.parameters) + ")";
    functions.push_back(std::move(function));
  }
  return functions;
}

std::vector<ValueList> value_lists() {
  using namespace gl;
  ValueLists lists;
#define SHADOWLAB_GL(result, name, parameters, ...) \
  lists.add_all<result __VA_OPT__(, ) __VA_ARGS__>();
#define SHADOWLAB_GL_OWN SHADOWLAB_GL
#define SHADOWLAB_GL_CORE(...)
#include "gl/functions.def"
#undef SHADOWLAB_GL
#undef SHADOWLAB_GL_OWN
#undef SHADOWLAB_GL_CORE
  lists.add<Truth>();
  auto all = lists.take();
  expect_all_constants(all);
  return all;
}

}  // namespace shadowlab::docs
