// The table of GL's functions, loaded from the current context, and the one way to call them.
//
// Several libraries in one process may export the same gl* symbols (libGL and libOSMesa do), so
// nothing of ours links to GL: every call goes through a table that its context filled.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>

#include "context/context.h"
#include "gl/kinds.h"
#include "gl/recorder.h"
#include "gl/work.h"

#ifndef APIENTRY
#define APIENTRY
#endif

namespace shadowlab::gl {

/// One number for each function, in the order of functions.def.
enum class FunctionId : std::uint16_t {
#define SHADOWLAB_GL(result, name, ...) name,
#define SHADOWLAB_GL_OWN SHADOWLAB_GL
#define SHADOWLAB_GL_CORE SHADOWLAB_GL
#include "gl/functions.def"
#undef SHADOWLAB_GL
#undef SHADOWLAB_GL_OWN
#undef SHADOWLAB_GL_CORE
  count
};

constexpr bool draws(FunctionId id) {
  return id == FunctionId::DrawArrays || id == FunctionId::DrawElements ||
         id == FunctionId::DrawArraysInstanced;
}

constexpr bool sets_uniform(FunctionId id) {
  return id >= FunctionId::Uniform1f && id <= FunctionId::UniformMatrix4fv;
}

/// Told of every draw before it is made: `draw` makes it, under the state of that moment.
class DrawObserver {
 public:
  virtual ~DrawObserver() = default;
  virtual void before_draw(const std::function<void()>& draw) = 0;
};

/// What every function of a table shares.
struct CallContext {
  const context::Context* context = nullptr;
  Recorder* recorder = nullptr;
  GLuint main_frame = 0;  ///< the framebuffer object that 0 stands for
  /// How often a recipe set uniforms of the current program by itself: what the core knows of their
  /// values is then out of date.
  std::uint64_t foreign_uniforms = 0;
  DrawObserver* draws = nullptr;
  mutable Work work{};  ///< counted by calls through a table that otherwise only reads this
};

/// While it lives, calls leave no trace: for what the core draws on its own account.
class Untraced {
 public:
  explicit Untraced(CallContext& context) : context_(context), before_(context.recorder) {
    context.recorder = nullptr;
  }
  ~Untraced() { context_.recorder = before_; }
  Untraced(const Untraced&) = delete;
  Untraced& operator=(const Untraced&) = delete;

 private:
  CallContext& context_;
  Recorder* before_;
};

/// One GL function: call it as GL's own. The main frame is 0, its colour buffer GL_BACK.
template <FunctionId Id, class Result, class... Kinds>
class Function {
 public:
  using Pointer = RawOf<Result>(APIENTRY*)(RawOf<Kinds>...);
  static constexpr FunctionId id = Id;
  static constexpr std::size_t arity = sizeof...(Kinds);

  RawOf<Result> operator()(CppOf<Kinds>... arguments) const {
    // Decided before the call, so that without a trace there is nothing to keep across it.
    if (shared->recorder) [[unlikely]]
      return recorded(arguments...);
    return unrecorded(arguments...);
  }

  /// The same without a trace: for what the core does on its own account.
  RawOf<Result> unrecorded(CppOf<Kinds>... arguments) const {
    if constexpr (draws(Id)) {
      count_draw(arguments...);
      if (shared->draws) [[unlikely]] {
        shared->draws->before_draw(
            [&] { pointer(Traits<Kinds>::lower(arguments, shared->main_frame)...); });
      }
    }
    if constexpr ((std::is_same_v<Kinds, Bytes> || ...)) (count_upload(arguments), ...);
    return pointer(Traits<Kinds>::lower(arguments, shared->main_frame)...);
  }

  /// A trace without the call: for what the core does in GL's place.
  void record(CppOf<Kinds>... arguments) const {
    if (Recorder* recorder = shared->recorder) [[unlikely]] {
      recorder->record<Kinds...>(static_cast<std::uint16_t>(Id), arguments...);
    }
  }

  explicit operator bool() const { return pointer != nullptr; }

  Pointer pointer = nullptr;
  const CallContext* shared = nullptr;

 private:
  [[gnu::noinline, gnu::cold]] RawOf<Result> recorded(CppOf<Kinds>... arguments) const {
    if constexpr (std::is_void_v<RawOf<Result>>) {
      unrecorded(arguments...);
      record(arguments...);
    } else {
      const auto result = unrecorded(arguments...);
      record(arguments...);
      return result;
    }
  }
  template <class Argument>
  void count_upload(const Argument& argument) const {
    if constexpr (std::is_same_v<Argument, CppOf<Bytes>>) shared->work.add_upload(argument.size());
  }
  void count_draw(GLenum mode, GLint, GLsizei vertices, GLsizei instances = 1) const {
    shared->work.add_draw(mode, vertices, instances);
  }
  void count_draw(GLenum mode, GLsizei vertices, GLenum, GLsizeiptr) const {
    shared->work.add_draw(mode, vertices, 1);
  }
};

struct Functions {
#define SHADOWLAB_GL(result, name, parameters, ...) \
  Function<FunctionId::name, result __VA_OPT__(, ) __VA_ARGS__> name;
#define SHADOWLAB_GL_OWN SHADOWLAB_GL
#define SHADOWLAB_GL_CORE SHADOWLAB_GL
#include "gl/functions.def"
#undef SHADOWLAB_GL
#undef SHADOWLAB_GL_OWN
#undef SHADOWLAB_GL_CORE

  /// Fills the table; `loader` maps "glEnable" to the current context's function, or null.
  /// Functions younger than OpenGL 3.3 stay null where the context's version (major × 10 + minor)
  /// is under 45: some loaders answer for functions that their context does not have. Throws
  /// MachineError where the context lacks what 3.3 has.
  void load(const std::function<void (*(const char*))()>& loader, int version,
            const CallContext* shared);
};

/// What is known of a function beside its pointer.
struct FunctionDescription {
  std::string_view name;        ///< "StencilFunc"
  std::string_view c_name;      ///< "glStencilFunc"
  std::string_view parameters;  ///< "func, ref, mask"
  enum class Use { plain, own, core } use;
  std::string_view result;  ///< the kind's name, "Nothing" for none
  std::string_view kinds;   ///< "CompareFunction, Int, Mask"
  std::string (*const* formatters)(std::uint64_t, std::span<const std::byte>);
  std::size_t arity;
};

std::span<const FunctionDescription> function_descriptions();
const FunctionDescription& describe(FunctionId id);

/// The name of parameter `index` (0-based): "mask"; nothing where there are not so many.
std::string_view parameter_name(const FunctionDescription& function, std::size_t index);

}  // namespace shadowlab::gl
