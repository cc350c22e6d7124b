// The tracer's shadow rays beside Embree's own: the same triangles, the same segments, in one run.
// `embree` is rtcOccluded1 over a float triangle mesh, which decides in float; `exact` is the
// tracer, which decides in double. Then what whole pictures cost.
#include <benchmark/benchmark.h>
#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <map>
#include <memory>
#include <random>

#include <glm/gtc/matrix_transform.hpp>

#include "truth/tracer.h"

namespace {

using namespace shadowlab;

// A floor, and spheres over it that make up about `triangles`.
scene::Scene spheres(int triangles) {
  scene::Scene result;
  const auto add = [&](scene::Mesh mesh, scene::Role role, glm::dvec3 at) {
    scene::Object object;
    object.mesh = std::make_shared<const scene::Mesh>(std::move(mesh));
    object.model = glm::translate(glm::dmat4(1), at);
    object.role = role;
    result.objects.push_back(std::move(object));
  };
  add(scene::plane(12, 12), scene::Role::both, glm::dvec3(0));
  const int stacks = static_cast<int>(std::sqrt(triangles / 16.0 / 4)) + 2;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> place(-3, 3), height(0.4, 2);
  for (int i = 0; i < 16; ++i) {
    add(scene::sphere(0.5, 2 * stacks, stacks), scene::Role::both,
        {place(random), height(random), place(random)});
  }
  result.camera = {.eye = {0, 4, 8}, .target = {0, 0.5, 0}};
  return result;
}

constexpr glm::dvec3 kLight(2, 7, 1);
constexpr int kSize = 256;

// One scene with the points that the camera sees, for all benchmarks.
struct Setting {
  explicit Setting(int triangles) : scene(spheres(triangles)), tracer(scene) {
    for (const truth::Surface& s : tracer.surfaces(scene.camera, kSize, kSize).surfaces) {
      if (s.hit()) points.push_back(s.point);
    }
  }
  scene::Scene scene;
  truth::Tracer tracer;
  std::vector<glm::dvec3> points;
};

const Setting& setting(int triangles) {
  static std::map<int, std::unique_ptr<Setting>> settings;
  auto& found = settings[triangles];
  if (!found) found = std::make_unique<Setting>(triangles);
  return *found;
}

void rays_per_second(benchmark::State& state, std::size_t rays) {
  state.counters["rays/s"] =
      benchmark::Counter(static_cast<double>(rays), benchmark::Counter::kIsIterationInvariantRate);
}

// The same triangles in a scene of Embree's own.
class EmbreeScene {
 public:
  explicit EmbreeScene(const scene::Scene& of) {
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    for (const scene::Object& object : of.objects) add(object);
    rtcCommitScene(scene_);
  }
  ~EmbreeScene() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  int blocked(const std::vector<glm::dvec3>& points) const {
    int blocked = 0;
    for (const glm::dvec3& p : points) {
      const glm::dvec3 toward = kLight - p;
      RTCIntersectContext context;
      rtcInitIntersectContext(&context);
      RTCRay ray{};
      ray.org_x = static_cast<float>(p.x), ray.dir_x = static_cast<float>(toward.x);
      ray.org_y = static_cast<float>(p.y), ray.dir_y = static_cast<float>(toward.y);
      ray.org_z = static_cast<float>(p.z), ray.dir_z = static_cast<float>(toward.z);
      ray.tnear = 1e-4f;  // the offset that it needs
      ray.tfar = 1;
      ray.mask = 0xFFFFFFFFu;
      rtcOccluded1(scene_, &context, &ray);
      blocked += ray.tfar < 0;
    }
    return blocked;
  }

 private:
  void add(const scene::Object& object) {
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<glm::vec3*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                sizeof(glm::vec3), object.mesh->positions.size()));
    for (std::size_t i = 0; i < object.mesh->positions.size(); ++i) {
      vertices[i] = glm::vec3(object.model * glm::dvec4(object.mesh->positions[i], 1));
    }
    void* indices =
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(std::uint32_t), object.mesh->triangle_count());
    std::ranges::copy(object.mesh->indices, static_cast<std::uint32_t*>(indices));
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
  }

  RTCDevice device_ = rtcNewDevice(nullptr);
  RTCScene scene_ = rtcNewScene(device_);
};

int blocked_exactly(const Setting& here) {
  int blocked = 0;
  for (const glm::dvec3& p : here.points) {
    blocked += here.tracer.blocked(p, glm::dvec4(kLight, 1));
  }
  return blocked;
}

void embree(benchmark::State& state) {
  const Setting& here = setting(static_cast<int>(state.range(0)));
  const EmbreeScene scene(here.scene);
  for (auto _ : state) benchmark::DoNotOptimize(scene.blocked(here.points));
  rays_per_second(state, here.points.size());
}

void exact(benchmark::State& state) {
  const Setting& here = setting(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(blocked_exactly(here));
  rays_per_second(state, here.points.size());
}

// Both in turns: the tracer's rays a second over Embree's, by processor time.
void exact_over_embree(benchmark::State& state) {
  const Setting& here = setting(static_cast<int>(state.range(0)));
  const EmbreeScene scene(here.scene);
  std::clock_t theirs = 0, ours = 0;
  for (auto _ : state) {
    const std::clock_t begin = std::clock();
    benchmark::DoNotOptimize(scene.blocked(here.points));
    const std::clock_t middle = std::clock();
    benchmark::DoNotOptimize(blocked_exactly(here));
    theirs += middle - begin;
    ours += std::clock() - middle;
  }
  state.counters["ratio"] = static_cast<double>(theirs) / static_cast<double>(ours);
}

void hard_picture(benchmark::State& state) {
  const Setting& here = setting(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    benchmark::DoNotOptimize(here.tracer.visibility(
        here.scene.camera, {.position = glm::dvec4(kLight, 1)}, kSize, kSize));
  }
}

void soft_picture(benchmark::State& state) {
  const Setting& here = setting(10'000);
  const scene::Light light{.position = glm::dvec4(kLight, 1),
                           .shape = scene::Light::Shape::rectangle,
                           .half_u = {0.5, 0, 0},
                           .half_v = {0, 0, 0.5}};
  std::uint64_t rays = 0;
  for (auto _ : state) {
    const auto truth = here.tracer.soft_visibility(
        here.scene.camera, light, kSize, kSize,
        {.samples = 4096, .error = 1.0 / static_cast<double>(state.range(0))});
    rays += truth.rays;
  }
  state.counters["rays/pixel"] =
      static_cast<double>(rays) / static_cast<double>(state.iterations() * kSize * kSize);
  state.counters["rays/s"] =
      benchmark::Counter(static_cast<double>(rays), benchmark::Counter::kIsRate);
}

void edge_mask(benchmark::State& state) {
  const Setting& here = setting(10'000);
  double marked = 0;
  for (auto _ : state) {
    const auto mask = here.tracer.edge_mask(here.scene.camera, {.position = glm::dvec4(kLight, 1)},
                                            kSize, kSize, static_cast<int>(state.range(0)));
    marked = 0;
    for (const float value : mask.values) marked += value;
  }
  state.counters["marked"] = marked / (kSize * kSize);
}

void building(benchmark::State& state) {
  const scene::Scene scene = spheres(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(truth::Tracer(scene));
}

BENCHMARK(embree)->Arg(1'000)->Arg(10'000)->Arg(100'000)->Unit(benchmark::kMillisecond);
BENCHMARK(exact)->Arg(1'000)->Arg(10'000)->Arg(100'000)->Unit(benchmark::kMillisecond);
BENCHMARK(exact_over_embree)->Arg(1'000)->Arg(10'000)->Arg(100'000)->Unit(benchmark::kMillisecond);
BENCHMARK(hard_picture)->Arg(1'000)->Arg(100'000)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(soft_picture)->Arg(32)->Arg(256)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(edge_mask)->Arg(2)->Arg(4)->Arg(8)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(building)->Arg(10'000)->Arg(100'000)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
