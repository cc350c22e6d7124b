// Shadow volumes of closed meshes under a light that moves every frame: nanoseconds a triangle,
// beside the lecture's loop and beside streaming the bytes that must be read and written.
//
//   bench_volumes --benchmark_counters_tabular=true
//
// Read the ratios of one run; absolute times belong to the machine.
#include <array>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <map>
#include <new>
#include <numbers>

#include <benchmark/benchmark.h>

#include "scene/adjacency.h"
#include "scene/mesh.h"
#include "shadow/volume.h"
#include "shadow/volume_lecture.h"

namespace {
std::atomic<std::size_t> allocations{0};
}

// Every allocation of this program is counted.
[[gnu::noinline]] void* operator new(std::size_t size) {
  allocations.fetch_add(1, std::memory_order_relaxed);
  if (void* const p = std::malloc(size)) return p;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* p) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept { std::free(p); }

namespace shadowlab {
namespace {

using scene::Adjacency;
using scene::Mesh;

/// A torus of about `triangles` triangles, its vertices where a sculptor's hand put them: so that
/// the silhouette is not a sine, nor the facing a run.
Mesh caster(std::size_t triangles) {
  const int sides = static_cast<int>(std::sqrt(static_cast<double>(triangles) / 4));
  return scene::torus(0.5, 0.2, 2 * sides, sides);
}

const Adjacency& adjacency_of(std::size_t triangles) {
  static std::map<std::size_t, Adjacency> made;
  auto [at, missing] = made.try_emplace(triangles);
  if (missing) at->second = scene::adjacency(caster(triangles));
  return at->second;
}

/// A light that goes round the caster, outside its box. Sines take as long as a hundred triangles,
/// so they are taken before any clock runs.
glm::dvec4 light_at(std::size_t frame) {
  static const auto lights = [] {
    std::array<glm::dvec4, 1024> made;
    for (std::size_t i = 0; i < made.size(); ++i) {
      const double angle = static_cast<double>(i) * std::numbers::phi;
      made[i] = {3 * std::cos(angle), 2 + std::sin(3 * angle), 3 * std::sin(angle), 1};
    }
    return made;
  }();
  return lights[frame % lights.size()];
}

void report(benchmark::State& state, std::size_t triangles) {
  // Google Benchmark prints 1.2n for 1.2e-9 seconds.
  state.counters["s/triangle"] =
      benchmark::Counter(static_cast<double>(state.iterations() * triangles),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["triangles"] = static_cast<double>(triangles);
}

void build(benchmark::State& state, shadow::Caps caps) {
  shadow::VolumeBuilder builder(adjacency_of(static_cast<std::size_t>(state.range(0))));
  std::size_t frame = 0;
  for (; frame < 16; ++frame) builder.build(light_at(frame), {.caps = caps});
  const std::size_t before = allocations;
  std::size_t written = 0;
  for (auto _ : state) {
    const auto built = builder.build(light_at(frame++), {.caps = caps});
    benchmark::DoNotOptimize(built.all.data());
    written = built.all.size();
  }
  state.counters["allocations"] = static_cast<double>(allocations - before);
  state.counters["indices"] = static_cast<double>(written);
  report(state, builder.triangle_count());
}

void without_caps(benchmark::State& state) { build(state, shadow::Caps::none); }
void with_caps(benchmark::State& state) { build(state, shadow::Caps::both); }

// With the instructions that `build` may use.
__attribute__((target_clones("arch=x86-64-v3", "default"))) std::uint64_t sum_of(
    const std::uint64_t* p, std::size_t n) {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < n; ++i) sum += p[i];
  return sum;
}

/// Reads and writes, once and in order, as many bytes as `build` must: a triangle's plane (16), its
/// coefficient (1 written, 1 read) and whether it has an edge of each run (1); 8 for each edge that
/// is looked up; for caps the three indices of the triangles that are copied, twice, and the
/// coefficients twice; and the indices that come out.
void stream(benchmark::State& state, shadow::Caps caps) {
  shadow::VolumeBuilder builder(adjacency_of(static_cast<std::size_t>(state.range(0))));
  const std::size_t triangles = builder.triangle_count();
  const auto built = builder.build(light_at(16), {.caps = caps});
  std::size_t reads = triangles * (16 + 1 + builder.run_count()) + builder.indexed_edge_count() * 8;
  if (caps == shadow::Caps::both) {
    reads += triangles * 2 + built.front_cap.size_bytes() + built.back_cap.size_bytes();
  }
  const std::size_t writes = triangles + built.all.size_bytes();
  std::vector<std::uint64_t> source(reads / 8 + 1, 1), target(writes / 8 + 1);
  int value = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(sum_of(source.data(), source.size()));
    std::memset(target.data(), ++value & 0xff, writes);
    benchmark::ClobberMemory();
  }
  state.counters["B/triangle"] =
      static_cast<double>(reads + writes) / static_cast<double>(triangles);
  report(state, triangles);
}

void stream_without_caps(benchmark::State& state) { stream(state, shadow::Caps::none); }
void stream_with_caps(benchmark::State& state) { stream(state, shadow::Caps::both); }

void lecture_loop(benchmark::State& state) {
  const Adjacency& mesh = adjacency_of(static_cast<std::size_t>(state.range(0)));
  const auto next = scene::next(mesh);
  std::size_t frame = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        shadow::volume_lecture(mesh, next, light_at(frame++), shadow::Edges::silhouette));
  }
  report(state, mesh.triangles.size());
}

void adjacency(benchmark::State& state) {
  const Mesh mesh = caster(static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(scene::adjacency(mesh));
  report(state, mesh.triangle_count());
}

void sizes(benchmark::internal::Benchmark* bench) {
  for (const int triangles : {1'000, 10'000, 100'000, 1'000'000}) bench->Arg(triangles);
}

BENCHMARK(without_caps)->Apply(sizes);
BENCHMARK(stream_without_caps)->Apply(sizes);
BENCHMARK(with_caps)->Apply(sizes);
BENCHMARK(stream_with_caps)->Apply(sizes);
BENCHMARK(lecture_loop)->Apply(sizes);
BENCHMARK(adjacency)->Apply(sizes)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace shadowlab

BENCHMARK_MAIN();
