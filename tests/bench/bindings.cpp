// What a call of GL costs from Lua, with all checks, against the same call in C through the same
// pointers: nanoseconds a call, twelve state functions as a student writes them, `gl` a global.
//
//   bench_bindings
//
// Processor time, medians of interleaved repetitions. Read the differences of one run; they are the
// price of Lua's call and of our checks, glGetError included. "off" is a call of the function table
// in C++ with the recorder off.
#include <fmt/format.h>

#include "gl/graphics.h"
#include "lua/stage.h"
#include "medians.h"

namespace shadowlab {
namespace {

constexpr int calls = 10'000;  // an iteration: the start of a script weighs nothing
constexpr int unrolled = 10;

struct Measured {
  const char* name;
  const char* lua;
  void (*in_c)(const gl::Functions&);
  void (*in_table)(const gl::Functions&);
};

#define SHADOWLAB_MEASURED(NAME, LUA, ...)                                                 \
  {                                                                                        \
#NAME, LUA,                                                                            \
        [](const gl::Functions&                                                            \
               gl) { gl.NAME.pointer(__VA_ARGS__); }, [](const gl::Functions&              \
                                                             gl) { gl.NAME(__VA_ARGS__); } \
  }

constexpr Measured functions[] = {
    SHADOWLAB_MEASURED(Enable, "gl.Enable(gl.STENCIL_TEST)", GL_STENCIL_TEST),
    SHADOWLAB_MEASURED(Disable, "gl.Disable(gl.BLEND)", GL_BLEND),
    SHADOWLAB_MEASURED(DepthMask, "gl.DepthMask(true)", GL_TRUE),
    SHADOWLAB_MEASURED(ColorMask, "gl.ColorMask(true, true, true, true)", GL_TRUE, GL_TRUE, GL_TRUE,
                       GL_TRUE),
    SHADOWLAB_MEASURED(DepthFunc, "gl.DepthFunc(gl.LEQUAL)", GL_LEQUAL),
    SHADOWLAB_MEASURED(StencilFunc, "gl.StencilFunc(gl.ALWAYS, 1, 0xFF)", GL_ALWAYS, 1, 0xFF),
    SHADOWLAB_MEASURED(StencilOp, "gl.StencilOp(gl.KEEP, gl.KEEP, gl.REPLACE)", GL_KEEP, GL_KEEP,
                       GL_REPLACE),
    SHADOWLAB_MEASURED(StencilMask, "gl.StencilMask(0xFF)", 0xFF),
    SHADOWLAB_MEASURED(BlendFunc, "gl.BlendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA)",
                       GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA),
    SHADOWLAB_MEASURED(CullFace, "gl.CullFace(gl.FRONT)", GL_FRONT),
    SHADOWLAB_MEASURED(PolygonOffset, "gl.PolygonOffset(1, 2)", 1, 2),
    SHADOWLAB_MEASURED(Viewport, "gl.Viewport(0, 0, 64, 64)", 0, 0, 64, 64),
};

enum class Trace { off, on };

class Bench {
 public:
  Bench()
      : graphics_(context::create(), 64, 64),
        state_({}, [](std::string_view) {}),
        stage_{state_, graphics_, nullptr, {}, {}} {
    lua::open_all(stage_);
  }

  template <void (*Measured::*Call)(const gl::Functions&)>
  void in_c(benchmark::State& state, const Measured& measured) {
    graphics_.begin_frame();
    const auto call = measured.*Call;
    for (auto _ : state) {
      for (int i = 0; i < calls; ++i) call(graphics_.gl);
    }
  }

  void in_lua(benchmark::State& state, const Measured& measured, Trace trace) {
    graphics_.begin_frame();
    std::string text = "for i = 1, ... do ";
    for (int i = 0; i < unrolled; ++i) text += std::string(measured.lua) + " ";
    state_.load_text(text + "end", measured.name);
    lua_State* L = state_.raw();
    if (trace == Trace::on) graphics_.trace_into(&recorder_);
    for (auto _ : state) {
      recorder_.clear();
      lua_pushvalue(L, -1);
      lua_pushinteger(L, calls / unrolled);
      state_.call(1, 0);
    }
    graphics_.trace_into(nullptr);
    lua_settop(L, 0);
  }

 private:
  gl::Graphics graphics_;
  gl::Recorder recorder_;
  lua::State state_;
  lua::Stage stage_;
};

void print_table(bench::Medians& medians) {
  const auto nanoseconds = [&](const char* kind, const char* name) {
    return medians.median(fmt::format("{}/{}", kind, name)) / calls * 1e9;
  };
  fmt::print("{:<14}{:>7}{:>7}{:>7}{:>8}{:>10}{:>12}{:>14}\n", "ns a call", "C", "off", "Lua",
             "traced", "off - C", "Lua - C", "traced - C");
  std::array<double, 3> sums{};
  for (const Measured& measured : functions) {
    const double c = nanoseconds("c", measured.name), off = nanoseconds("off", measured.name),
                 lua = nanoseconds("lua", measured.name),
                 traced = nanoseconds("traced", measured.name);
    fmt::print("{:<14}{:>7.1f}{:>7.1f}{:>7.1f}{:>8.1f}{:>10.1f}{:>12.1f}{:>14.1f}\n", measured.name,
               c, off, lua, traced, off - c, lua - c, traced - c);
    sums[0] += off - c;
    sums[1] += lua - c;
    sums[2] += traced - c;
  }
  const double count = std::size(functions);
  fmt::print("{:<43}{:>10.1f}{:>12.1f}{:>14.1f}\n", "mean", sums[0] / count, sums[1] / count,
             sums[2] / count);
  fmt::print("{:<43}{:>10}{:>12}{:>14}\n", "target", "1", "45", "80");
}

}  // namespace
}  // namespace shadowlab

int main(int argc, char** argv) {
  using namespace shadowlab;
  Bench bench;
  const auto add = [](const char* kind, const Measured& measured, auto run) {
    benchmark::RegisterBenchmark(fmt::format("{}/{}", kind, measured.name).c_str(), run);
  };
  for (const Measured& measured : functions) {
    add("c", measured,
        [&](benchmark::State& state) { bench.in_c<&Measured::in_c>(state, measured); });
    add("off", measured,
        [&](benchmark::State& state) { bench.in_c<&Measured::in_table>(state, measured); });
    add("lua", measured,
        [&](benchmark::State& state) { bench.in_lua(state, measured, Trace::off); });
    add("traced", measured,
        [&](benchmark::State& state) { bench.in_lua(state, measured, Trace::on); });
  }
  bench::Medians medians(bench::Clock::processor);
  bench::run_interleaved(argc, argv, medians, "--benchmark_repetitions=9",
                         "--benchmark_min_time=0.02");
  print_table(medians);
}
