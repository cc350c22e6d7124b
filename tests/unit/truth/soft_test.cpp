// The tracer against the closed forms.
#include <cmath>

#include <gtest/gtest.h>

#include "core/error.h"
#include "scenes.h"
#include "truth/closed_forms.h"
#include "truth/tracer.h"

namespace shadowlab::truth {
namespace {

using Shape = scene::Light::Shape;
constexpr double kWide = 50;  // stands for an infinite extent
constexpr Heights kHeights{1, 3};

scene::Light area_light(Shape shape, double half, glm::dvec3 at = {0, kHeights.light, 0}) {
  return {.position = {at, 1},
          .shape = shape,
          .half_u = {half, 0, 0},
          .half_v = {0, 0, half},
          .radius = half};
}

scene::Scene over_floor(scene::Object caster) {
  scene::Scene scene;
  scene.objects = {floor_object(100), std::move(caster)};
  return scene;
}

// The floor under the caster, straight from above with the caster out of sight.
scene::Camera floor_camera(double width) {
  scene::Camera camera = above(width);
  camera.near = 999.5;
  return camera;
}

// RMSE over the picture of floor_camera(width), against expected(x, z).
template <typename Expected>
double rmse(const image::FloatImage& image, double width, Expected expected) {
  double squares = 0;
  for (int j = 0; j < image.height; ++j) {
    for (int i = 0; i < image.width; ++i) {
      const double x = (i + 0.5) * width / image.width - width / 2;
      const double z = (j + 0.5) * width / image.height - width / 2;
      const double error =
          image.values[static_cast<std::size_t>(j * image.width + i)] - expected(glm::dvec2(x, z));
      squares += error * error;
    }
  }
  return std::sqrt(squares / static_cast<double>(image.values.size()));
}

// A half-plane with its edge turned by 20 degrees in the picture, so that rows and columns of
// pixels lie at all distances from it.
struct Turned {
  double angle = glm::radians(20.0);
  glm::dvec3 along{std::cos(angle), 0, std::sin(angle)};
  glm::dvec3 across{-std::sin(angle), 0, std::cos(angle)};

  scene::Scene scene(double edge) const {
    scene::Object caster = slab(kHeights.caster, {-kWide, -kWide}, {edge, kWide});
    caster.model = glm::rotate(glm::dmat4(1), -angle, glm::dvec3(0, 1, 0));
    return over_floor(std::move(caster));
  }
};

TEST(SoftTruth, of_a_half_plane_converges_to_the_ramp_of_each_light) {
  const double half = 0.6, edge = 0.125, width = 2;
  const Turned turned;
  const Tracer tracer(turned.scene(edge));
  const double p = penumbra_half_width(half, kHeights);
  const double from = projected_edge(edge, 0, kHeights);
  for (const Shape shape : {Shape::rectangle, Shape::disk}) {
    scene::Light light = area_light(shape, half);
    light.half_u = half * turned.along;
    light.half_v = half * turned.across;
    double error[4];
    for (int k = 0; k < 4; ++k) {
      const image::FloatImage image = tracer.visibility(floor_camera(width), light, 48, 48,
                                                        {.samples = 16 << (2 * k), .seed = 1});
      error[k] = rmse(image, width, [&](glm::dvec2 x) {
        const double d = x.x * turned.along.x + x.y * turned.along.z - from;
        return shape == Shape::disk ? half_plane_under_disk(d, p)
                                    : half_plane_under_rectangle(d, p);
      });
    }
    const double slope = std::log2(error[3] / error[0]) / 6;
    std::printf("%s: RMSE %.4f %.4f %.5f %.5f at N = 16 64 256 1024, slope %.2f\n",
                shape == Shape::disk ? "disk" : "rectangle", error[0], error[1], error[2], error[3],
                slope);
    // One edge cuts the light: Owen's error falls as N^-0.75 over many sets of points, and starts
    // under 0.04; this is one set, so the slope has some play.
    EXPECT_LT(slope, -0.6);
    EXPECT_LT(error[0], 0.04);
    EXPECT_LT(error[3], 0.003);
  }
}

TEST(SoftTruth, of_a_corner_is_the_product_form) {
  const double half = 0.5, width = 2;
  const Tracer tracer(over_floor(slab(kHeights.caster, {-kWide, -kWide}, {0.1f, -0.2f})));
  const image::FloatImage image = tracer.visibility(
      floor_camera(width), area_light(Shape::rectangle, half), 48, 48, {.samples = 1024});
  const double error = rmse(image, width, [&](glm::dvec2 x) {
    return rectangle_under_rectangle(x, {-kWide, -kWide}, {0.1f, -0.2f}, {0, 0}, {half, half},
                                     kHeights);
  });
  EXPECT_LT(error, 0.003);  // as for one edge: each factor is one
}

// A sphere so far away that its rays are as good as parallel: at radius/distance = 1/1000 the ramp
// is off by that order.
TEST(SoftTruth, of_a_far_sphere_is_the_linear_ramp) {
  const double width = 0.02, half = 1;
  const Heights heights{1, 1000};
  const Tracer tracer(over_floor(slab(heights.caster, {-kWide, -kWide}, {0, kWide})));
  const image::FloatImage image =
      tracer.visibility(floor_camera(width), area_light(Shape::sphere, half, {0, 1000, 0}), 32, 32,
                        {.samples = 1024});
  const double p = penumbra_half_width(half, heights);
  EXPECT_LT(rmse(image, width, [&](glm::dvec2 x) { return half_plane_under_sphere(x.x, p); }),
            0.004);
}

TEST(SoftTruth, of_a_light_that_shrinks_to_a_point_is_the_hard_shadow) {
  const Tracer tracer(over_floor(slab(kHeights.caster, {-0.37, -0.2}, {0.31, 0.4})));
  const auto hard =
      tracer.visibility(floor_camera(2), {.position = {0, kHeights.light, 0, 1}}, 64, 64);
  for (const Shape shape : {Shape::rectangle, Shape::disk, Shape::sphere}) {
    EXPECT_EQ(
        tracer.visibility(floor_camera(2), area_light(shape, 1e-9), 64, 64, {.samples = 16}).values,
        hard.values);
  }
}

TEST(SoftTruth, of_a_caster_on_the_receiver_is_the_hard_shadow) {
  const Tracer tracer(over_floor(slab(1e-9, {-0.37, -0.2}, {0.31, 0.4})));
  // From below: from above the floor is hidden by the caster, as far as a depth can tell.
  const scene::Camera camera{
      .eye = {0, -1000, 0}, .up = {0, 0, -1}, .fovy = above(2).fovy, .near = 990, .far = 1001};
  const auto soft =
      tracer.visibility(camera, area_light(Shape::rectangle, 1), 64, 64, {.samples = 16});
  const auto hard = tracer.visibility(camera, {.position = {0, kHeights.light, 0, 1}}, 64, 64);
  EXPECT_EQ(soft.values, hard.values);
}

TEST(SoftTruth, under_a_light_larger_than_the_caster_has_no_umbra) {
  // Hidden of the light: the caster (0.2 across) thrown back, 0.6 of 2 across: 1 - 0.3².
  const Tracer tracer(over_floor(slab(kHeights.caster, {-0.1, -0.1}, {0.1, 0.1})));
  const auto image = tracer.visibility(floor_camera(1e-3), area_light(Shape::rectangle, 1), 1, 1,
                                       {.samples = 4096});
  EXPECT_NEAR(image.values[0], 1 - 0.3 * 0.3, 1e-3);  // an Owen net of 4096 points
}

TEST(SoftTruth, with_the_points_of_a_recipe_is_the_mean_of_its_hard_shadows) {
  Random random(4);
  const Tracer tracer(clutter(random));
  const scene::Camera camera{.eye = {1, 3, 5}, .target = {0, 0.5, 0}};
  const scene::Light light = area_light(Shape::disk, 0.7, {1, 4, 2});
  for (const auto pattern : {shadow::Pattern::jitter, shadow::Pattern::hammersley}) {
    const auto soft =
        tracer.visibility(camera, light, 40, 40, {.samples = 9, .pattern = pattern, .seed = 3});
    std::vector<double> sum(soft.values.size());
    for (const glm::dvec3 point : shadow::samples(light, 9, pattern, 3)) {
      const auto hard = tracer.visibility(camera, {.position = {point, 1}}, 40, 40);
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += hard.values[i];
    }
    for (std::size_t i = 0; i < sum.size(); ++i) {
      ASSERT_EQ(soft.values[i], static_cast<float>(sum[i] / 9));
    }
  }
}

TEST(SoftTruth, that_adapts_meets_the_error_asked_for_with_fewer_rays) {
  const double half = 0.6, width = 4, edge = 0.125;
  const Turned turned;
  const Tracer tracer(turned.scene(edge));
  const scene::Light light = area_light(Shape::disk, half);
  const double p = penumbra_half_width(half, kHeights);
  const double from = projected_edge(edge, 0, kHeights);
  for (const double asked : {0.05, 0.02, 0.01, 0.005}) {
    const SoftTruth truth = tracer.soft_visibility(floor_camera(width), light, 64, 64,
                                                   {.samples = 1 << 14, .error = asked});
    std::size_t within = 0, penumbra = 0;
    double squares = 0;
    for (int j = 0; j < 64; ++j) {
      for (int i = 0; i < 64; ++i) {
        const double x = (i + 0.5) * width / 64 - width / 2, z = (j + 0.5) * width / 64 - width / 2;
        const double d = x * turned.along.x + z * turned.along.z - from;
        if (std::abs(d) > p) continue;
        const double error = truth.visibility.values[static_cast<std::size_t>(j * 64 + i)] -
                             half_plane_under_disk(d, p);
        ++penumbra;
        within += std::abs(error) <= 2 * asked;
        squares += error * error;
      }
    }
    const double share = static_cast<double>(within) / static_cast<double>(penumbra);
    std::printf("asked %.3f: RMSE in the penumbra %.4f, within 2 errors %.3f, %.1f rays a pixel\n",
                asked, std::sqrt(squares / static_cast<double>(penumbra)), share,
                static_cast<double>(truth.rays) / (64 * 64));
    EXPECT_LE(std::sqrt(squares / static_cast<double>(penumbra)), asked);
    EXPECT_GE(share, 0.95);
    EXPECT_EQ(truth.unconverged, 0u);
  }
}

TEST(SoftTruth, refuses_what_it_cannot_sample) {
  const Tracer tracer(over_floor(slab(1, {0, 0}, {1, 1})));
  const scene::Light light = area_light(Shape::disk, 1);
  EXPECT_THROW(tracer.visibility(floor_camera(1), light, 4, 4, {.samples = 0}), InputError);
  EXPECT_THROW(tracer.visibility(floor_camera(1), light, 4, 4, {.error = 0.0}), InputError);
  EXPECT_THROW(tracer.visibility(floor_camera(1), {.position = {0, 0, 0, 0}}, 4, 4), InputError);
  EXPECT_THROW(tracer.visibility(floor_camera(1), light, 0, 4), InputError);
}

}  // namespace
}  // namespace shadowlab::truth
