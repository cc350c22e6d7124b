#include "truth/tracer.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/error.h"
#include "scenes.h"

namespace shadowlab::truth {
namespace {

using scene::Role;

double mean(const image::FloatImage& image) {
  double sum = 0;
  for (const float value : image.values) sum += value;
  return sum / static_cast<double>(image.values.size());
}

TEST(Surfaces, at_a_pixel_centre_are_the_first_between_the_planes_seen_from_either_side) {
  scene::Scene scene;
  scene.objects = {floor_object(), slab(2, {-1, -1}, {0, 1})};
  const Tracer tracer(scene);
  scene::Camera camera = above(4);
  const SurfaceImage image = tracer.surfaces(camera, 4, 4);
  // Column 0 is x = -1.5, beside the slab (-1 to 0); column 1 is x = -0.5, over it.
  EXPECT_EQ(image.at(0, 1).object, 0u);
  EXPECT_EQ(image.at(1, 1).object, 1u);
  EXPECT_DOUBLE_EQ(image.at(1, 1).depth, 998);
  // 1e-12: a few roundings of the eye's distance, 1000.
  EXPECT_NEAR(image.at(0, 0).point.x, -1.5, 1e-12);
  EXPECT_NEAR(image.at(0, 0).point.z, -1.5, 1e-12);  // the top row is toward -z, which is up here
  EXPECT_EQ(image.at(0, 0).normal, glm::dvec3(0, 1, 0));

  camera.near = 998 + 1e-9;  // past the slab, by less than a float can tell
  EXPECT_EQ(tracer.surfaces(camera, 4, 4).at(1, 1).object, 0u);
  camera.far = 999.5;  // before the floor
  EXPECT_FALSE(tracer.surfaces(camera, 4, 4).at(1, 1).hit());

  scene::Camera below{.eye = {-0.5, 1, 0}, .target = {-0.5, 2, 0}, .up = {0, 0, 1}};
  EXPECT_EQ(tracer.surfaces(below, 1, 1).at(0, 0).object, 1u);
  EXPECT_EQ(tracer.surfaces(below, 1, 1).at(0, 0).depth, 1);
}

TEST(Surfaces, are_where_the_projection_says) {
  Random random(5);
  const scene::Scene scene = clutter(random);
  const Tracer tracer(scene);
  const scene::Camera camera{.eye = {1, 3, 5}, .target = {0, 0.5, 0}};
  const int w = 40, h = 24;
  const SurfaceImage image = tracer.surfaces(camera, w, h);
  const glm::dmat4 to_clip = camera.projection(40.0 / 24) * camera.view();
  for (int y = 0; y < h; ++y) {
    for (int x = 0; x < w; ++x) {
      if (!image.at(x, y).hit()) continue;
      const glm::dvec4 clip = to_clip * glm::dvec4(image.at(x, y).point, 1);
      // 1e-12: rounding of coordinates of about 10.
      EXPECT_NEAR((clip.x / clip.w + 1) / 2 * w, x + 0.5, 1e-12 * w);
      EXPECT_NEAR((1 - clip.y / clip.w) / 2 * h, y + 0.5, 1e-12 * h);
      EXPECT_NEAR(clip.w, image.at(x, y).depth, 1e-12 * clip.w);
    }
  }
}

// Through every vertex and along every edge of closed meshes, from outside to outside past the
// middle.
TEST(Tracer, lets_no_segment_slip_through_an_edge_or_a_vertex_of_a_closed_mesh) {
  Random random(6);
  for (const scene::Mesh& mesh :
       {scene::sphere(1, 32, 17), scene::box(), scene::tetrahedron(1), scene::sphere(1, 3, 2)}) {
    for (const glm::dvec3 offset : {glm::dvec3(0), glm::dvec3(1e6, -1e6, 3e5)}) {
      scene::Scene scene;
      scene.objects = {object(mesh, Role::caster, offset)};
      scene.objects[0].model = glm::rotate(scene.objects[0].model, 0.7, {0.3, 0.5, 0.2});
      const Tracer tracer(scene);
      for (std::size_t k = 0; k < mesh.indices.size(); ++k) {
        const std::size_t next = k % 3 == 2 ? k - 2 : k + 1;
        const auto world = [&](std::size_t corner) {
          return glm::dvec3(scene.objects[0].model *
                            glm::dvec4(mesh.positions[mesh.indices[corner]], 1));
        };
        for (const double share : {0.0, 0.5, uniform(random, 0, 1)}) {
          const glm::dvec3 aim = world(k) + share * (world(next) - world(k));
          // The middle of the mesh is inside, so the segment from there must cross the surface.
          const glm::dvec3 inside = offset + point_in(random, glm::dvec3(-0.05), glm::dvec3(0.05));
          ASSERT_TRUE(tracer.blocked(inside, glm::dvec4(inside + 3.0 * (aim - inside), 1)));
          ASSERT_TRUE(tracer.blocked(inside, glm::dvec4(aim - inside, 0)));
          ASSERT_TRUE(tracer.blocked(inside + 3.0 * (aim - inside), glm::dvec4(inside, 1)));
        }
      }
    }
  }
}

TEST(Tracer, blocks_nothing_from_a_receiver_and_nothing_beyond_the_light) {
  scene::Scene scene;
  scene.objects = {slab(1, {-1, -1}, {1, 1}), slab(2, {-1, -1}, {1, 1})};
  scene.objects[0].role = Role::receiver;
  const Tracer tracer(scene);
  EXPECT_FALSE(tracer.blocked({0.1, 0, 0.2}, {0.1, 1.5, 0.2, 1}));
  EXPECT_TRUE(tracer.blocked({0.1, 0, 0.2}, {0.1, 2.5, 0.2, 1}));
  EXPECT_FALSE(tracer.blocked({0.1, 0, 0.2}, {0.1, 2, 0.2, 1}));  // a light in the sheet
  EXPECT_FALSE(tracer.blocked({0.1, 2, 0.2}, {0.1, 5, 0.2, 1}));  // from the sheet
  EXPECT_TRUE(tracer.blocked({0.1, 0, 0.2}, {0, 1, 0, 0}));
  EXPECT_TRUE(tracer.blocked({0.1, 0, 0.2}, {0.2, 5, 0.4, 2}));  // w = 2: (0.1, 2.5, 0.2)
  EXPECT_FALSE(tracer.blocked({0.1, 0, 0.2}, {0, -1, 0, 0}));
}

TEST(Tracer, gives_the_hard_shadow_of_a_rectangle_to_the_pixel) {
  scene::Scene scene;
  scene.objects = {floor_object(), slab(1, {-0.37, -0.21}, {0.55, 0.4})};
  const Tracer tracer(scene);
  scene::Camera camera = above(4);
  camera.near = 999.5;  // past the slab: it casts and is not seen
  const glm::dvec3 light(0.3, 4, -0.2);
  const int n = 200;
  const image::FloatImage image = tracer.visibility(camera, point_light(light), n, n);
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const glm::dvec3 p((i + 0.5) * 4 / n - 2, 0, (j + 0.5) * 4 / n - 2);
      const glm::dvec3 c = p + (light - p) / 4.0;
      const float slab_there = c.x > -0.37f && c.x < 0.55f && c.z > -0.21f && c.z < 0.4f;
      ASSERT_EQ(image.values[static_cast<std::size_t>(j * n + i)], 1 - slab_there);
    }
  }
}

// Every caster of a closed mesh that a light cannot reach is dark, and no lit face is dotted with
// acne: on a convex solid the visibility is the sign of the side alone, without a tolerance.
TEST(Tracer, shadows_the_faces_of_a_convex_solid_that_turn_from_the_light_and_no_others) {
  Random random(7);
  for (const scene::Mesh& mesh : {scene::box(), scene::sphere(1, 24, 13), scene::tetrahedron(1)}) {
    scene::Scene scene;
    scene.objects = {object(mesh, Role::both, {0.1, 0.7, -0.3})};
    scene.objects[0].model = glm::rotate(scene.objects[0].model, 0.4, {0.3, 0.5, 0.2});
    const Tracer tracer(scene);
    for (int k = 0; k < 10; ++k) {
      const scene::Camera camera{.eye = 4.0 * point_in(random, glm::dvec3(0.4), glm::dvec3(1)),
                                 .target = {0.1, 0.7, -0.3}};
      const glm::dvec3 light = point_in(random, glm::dvec3(-6), glm::dvec3(6));
      if (glm::length(light - camera.target) < 1.5) continue;
      const SurfaceImage seen = tracer.surfaces(camera, 64, 64);
      const image::FloatImage lit = tracer.visibility(camera, point_light(light), 64, 64);
      for (std::size_t i = 0; i < lit.values.size(); ++i) {
        const Surface& s = seen.surfaces[i];
        const bool faces = !s.hit() || glm::dot(s.normal, light - s.point) > 0;
        ASSERT_EQ(lit.values[i], faces ? 1 : 0);
      }
    }
  }
}

TEST(Tracer, shadows_the_side_of_a_sheet_that_is_turned_from_the_light) {
  scene::Scene scene;
  scene.objects = {object(scene::plane(4, 4, 3, 3), Role::both)};
  const Tracer tracer(scene);
  const scene::Camera camera{.eye = {0, 3, 0.1}, .target = {0, 0, 0}};
  EXPECT_EQ(mean(tracer.visibility(camera, point_light({0.3, 2, 1}), 33, 33)), 1);
  const image::FloatImage dark = tracer.visibility(camera, point_light({0.3, -2, 1}), 33, 33);
  EXPECT_EQ(mean(dark), 0);  // the sheet fills the view
}

// The middle column of pixels looks along the edge that two columns of triangles share, so that
// every point there is on it, and off the planes beside it by its rounding.
TEST(Tracer, gives_no_acne_on_the_edges_within_a_tilted_sheet) {
  Random random(10);
  for (int k = 0; k < 50; ++k) {
    scene::Scene scene;
    scene.objects = {object(scene::plane(4, 4, 2, 7), Role::both)};
    scene.objects[0].model =
        glm::rotate(glm::dmat4(1), uniform(random, -0.6, 0.6), glm::dvec3(1, 0, 0));
    const scene::Camera camera{.eye = {0, 3, 0.1}, .target = {0, 0, 0}, .fovy = 30};
    const glm::dvec3 light = point_in(random, {-2, 3, -1}, {2, 5, 1});
    EXPECT_EQ(mean(Tracer(scene).visibility(camera, point_light(light), 65, 65)), 1);
  }
}

// A wall stands on the floor, the light behind it; the camera looks at the foot of the wall from
// the dark side, ever closer. An offset of any fixed size would let light through at the foot.
TEST(Tracer, leaks_no_light_under_a_caster_that_touches_its_receiver) {
  scene::Scene scene;
  scene.objects = {floor_object(), object(scene::box({1, 1, 8}), Role::both, {0.5, 0.5, 0})};
  const Tracer tracer(scene);
  for (const double distance : {1.0, 1e-3, 1e-6, 1e-9, 1e-11}) {
    const scene::Camera camera{.eye = {-distance, distance, 0.1},
                               .target = {0, 0, 0.1},
                               .fovy = 30,
                               .near = distance / 100,
                               .far = 100 * distance};
    const SurfaceImage seen = tracer.surfaces(camera, 64, 64);
    EXPECT_EQ(seen.at(10, 5).object, 1u);
    EXPECT_EQ(seen.at(10, 60).object, 0u);
    EXPECT_EQ(mean(tracer.visibility(camera, point_light({7, 3, 0.3}), 64, 64)), 0) << distance;
    EXPECT_EQ(mean(tracer.visibility(camera, point_light({-7, 3, 0.3}), 64, 64)), 1) << distance;
  }
}

TEST(Tracer, takes_a_light_on_a_vertex_on_an_edge_and_in_a_face) {
  scene::Scene scene;
  scene.objects = {floor_object(), object(scene::box(), Role::both, {0, 0.5, 0})};
  const Tracer tracer(scene);
  const scene::Camera camera{.eye = {2, 3, 4}, .target = {0, 0, 0}};
  // From the top face's corner the floor sees the light where it is on the light's side of either
  // wall that meets there: the two others cannot be between.
  const image::FloatImage lit = tracer.visibility(camera, point_light({0.5, 1, 0.5}), 64, 64);
  const SurfaceImage seen = tracer.surfaces(camera, 64, 64);
  for (std::size_t i = 0; i < lit.values.size(); ++i) {
    if (seen.surfaces[i].object != 0) continue;
    const glm::dvec3 p = seen.surfaces[i].point;
    ASSERT_EQ(lit.values[i], p.x > 0.5 || p.z > 0.5 ? 1 : 0);
  }
  for (const glm::dvec3 light :
       {glm::dvec3(0.5, 1, 0), glm::dvec3(0.1, 1, 0.2), glm::dvec3(0, 0, 0)}) {
    EXPECT_NO_THROW(tracer.visibility(camera, point_light(light), 64, 64));
  }
}

TEST(Tracer, draws_the_same_picture_a_million_units_away) {
  Random random(8);
  scene::Scene scene = clutter(random);
  scene::Camera camera{.eye = {1, 3, 5}, .target = {0, 0.5, 0}};
  const glm::dvec3 light(1, 5, 2);
  const image::FloatImage here = Tracer(scene).visibility(camera, point_light(light), 128, 128);
  for (const double d : {1e3, 1e5, 1e6}) {
    const glm::dvec3 offset(d, -d, d);
    scene::Scene moved = scene;
    for (scene::Object& o : moved.objects) o.model[3] += glm::dvec4(offset, 0);
    scene::Camera there = camera;
    there.eye += offset;
    there.target += offset;
    const image::FloatImage image =
        Tracer(moved).visibility(there, point_light(light + offset), 128, 128);
    std::size_t differ = 0;
    for (std::size_t i = 0; i < image.values.size(); ++i)
      differ += image.values[i] != here.values[i];
    // The world's own coordinates have lost 1e-10: a pixel of 0.02 would have to lie that near an
    // edge, odds of 1e-8 for each pixel on one.
    EXPECT_EQ(differ, 0u) << d;
  }
}

TEST(Tracer, gives_the_same_bits_for_any_number_of_threads) {
  Random random(9);
  const Tracer tracer(clutter(random));
  const scene::Camera camera{.eye = {1, 3, 5}, .target = {0, 0.5, 0}};
  const scene::Light light{.position = {1, 5, 2, 1},
                           .shape = scene::Light::Shape::rectangle,
                           .half_u = {0.5, 0, 0},
                           .half_v = {0, 0, 0.5}};
  const Sampling sampling{.samples = 256, .error = 0.05};
  const auto one = tracer.soft_visibility(camera, light, 48, 48, sampling, 1);
  const auto many = tracer.soft_visibility(camera, light, 48, 48, sampling, 7);
  EXPECT_EQ(one.visibility.values, many.visibility.values);
  EXPECT_EQ(one.rays, many.rays);
}

TEST(Tracer, takes_a_scene_without_casters_or_without_anything) {
  const scene::Camera camera{};
  EXPECT_EQ(mean(Tracer({}).visibility(camera, point_light({0, 3, 0}), 8, 8)), 1);
  scene::Scene scene;
  scene.objects = {floor_object()};
  EXPECT_EQ(mean(Tracer(scene).visibility(camera, point_light({0, -3, 0}), 8, 8)), 1);
  EXPECT_EQ(mean(Tracer({}).edge_mask(camera, point_light({0, 3, 0}), 8, 8)), 0);
}

}  // namespace
}  // namespace shadowlab::truth
