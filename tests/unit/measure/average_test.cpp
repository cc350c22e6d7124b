#include "measure/average.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numeric>

namespace shadowlab::measure {
namespace {

constexpr int size = 48;

// A box over a floor, under four points of a light.
class WrongAverage : public testing::Test {
 protected:
  WrongAverage() {
    add(scene::plane(20, 20), 0, scene::Role::receiver);
    add(scene::box({1, 1, 1}), 1.5, scene::Role::caster);
    scene.camera = {.eye = {3, 4, 5}, .target = {0, 0.5, 0}, .near = 0.1};
    scene.lights.assign(1, {.position = points[0]});
    tracer = std::make_unique<truth::Tracer>(scene);
    for (const glm::dvec4 point : points) {
      const scene::Light light{.position = point};
      hard.push_back(tracer->visibility(scene.camera, light, size, size));
      edges.push_back(tracer->edge_mask(scene.camera, light, size, size));
    }
  }

  void add(const scene::Mesh& mesh, double height, scene::Role role) {
    scene.objects.emplace_back();
    scene.objects.back().mesh = std::make_shared<scene::Mesh>(mesh);
    scene.objects.back().model[3].y = height;
    scene.objects.back().role = role;
  }

  // What `off(pixel)` points too few give, as a picture of eight bits has it.
  template <class Off>
  image::FloatImage averaged(Off off) const {
    image::FloatImage drawn = hard[0];
    for (std::size_t i = 0; i < drawn.values.size(); ++i) {
      const double share = (lit(i) - off(i)) / static_cast<double>(points.size());
      drawn.values[i] = static_cast<float>(std::round(255 * share) / 255);
    }
    return drawn;
  }
  int lit(std::size_t i) const {
    return std::accumulate(hard.begin(), hard.end(), 0,
                           [&](int sum, const auto& one) { return sum + (one.values[i] > 0); });
  }
  // Points that are lit there, and have an edge of their shadow.
  int lit_at_edges(std::size_t i) const {
    int count = 0;
    for (std::size_t k = 0; k < points.size(); ++k)
      count += hard[k].values[i] > 0 && edges[k].values[i] > 0;
    return count;
  }
  std::size_t wrong(const image::FloatImage& drawn) const {
    return wrong_average(scene, *tracer, {}, claim, points, drawn);
  }

  const std::vector<glm::dvec4> points{
      {1, 5, 0, 1}, {1.4, 5, 0.3, 1}, {0.8, 5.2, 0.5, 1}, {1.1, 4.8, -0.4, 1}};
  Claim claim{.on_receivers = false, .radius = 0.5};
  scene::Scene scene;
  std::unique_ptr<truth::Tracer> tracer;
  std::vector<image::FloatImage> hard, edges;
};

TEST_F(WrongAverage, is_none_in_the_average_of_the_points) {
  EXPECT_EQ(wrong(averaged([](std::size_t) { return 0; })), 0u);
}

TEST_F(WrongAverage, forgives_as_many_points_as_have_an_edge_there) {
  EXPECT_EQ(wrong(averaged([&](std::size_t i) { return lit_at_edges(i); })), 0u);
}

TEST_F(WrongAverage, is_every_pixel_with_one_more_off_than_those) {
  std::size_t off = 0;
  const auto surfaces = tracer->surfaces(scene.camera, size, size);
  const auto drawn = averaged([&](std::size_t i) {
    const bool more = surfaces.surfaces[i].hit() && lit(i) > lit_at_edges(i);
    off += more;
    return lit_at_edges(i) + (more ? 1 : 0);
  });
  EXPECT_GT(off, 1000u);
  // But where an edge that the mask's lattice of four a pixel misses is within 1/128 of a pixel: it
  // comes and goes, and there are few of those.
  EXPECT_LE(wrong(drawn), off);
  EXPECT_GE(wrong(drawn), off - off / 500);
}

TEST_F(WrongAverage, says_nothing_of_casters_where_the_claim_is_of_receivers) {
  const auto surfaces = tracer->surfaces(scene.camera, size, size);
  const auto drawn =
      averaged([&](std::size_t i) { return surfaces.surfaces[i].object == 1 ? -1 : 0; });
  EXPECT_GT(wrong(drawn), 50u);
  claim.on_receivers = true;
  EXPECT_EQ(wrong(drawn), 0u);
}

}  // namespace
}  // namespace shadowlab::measure
