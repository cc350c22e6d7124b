// The light's view: what it holds, how tightly, and where there is none.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "core/error.h"
#include "shadow/light_view.h"

namespace shadowlab::shadow {
namespace {

using glm::dmat4;
using glm::dvec3;
using glm::dvec4;

scene::Object object(scene::Mesh mesh, dvec3 at, scene::Role role) {
  scene::Object made;
  made.mesh = std::make_shared<const scene::Mesh>(std::move(mesh));
  made.model[3] = dvec4(at, 1);
  made.role = role;
  return made;
}

// A cube of side 2 with its middle at (0, 3, 0) over a floor of side 20 in y = 0.
scene::Scene cube_over_floor(dvec3 moved = dvec3(0)) {
  scene::Scene scene;
  scene.objects = {object(scene::plane(20, 20), moved, scene::Role::receiver),
                   object(scene::box(dvec3(2)), moved + dvec3(0, 3, 0), scene::Role::caster)};
  scene.camera.eye = moved + dvec3(0, 10, 30);
  scene.camera.target = moved;
  return scene;
}

dvec3 in_map(const LightView& light, dvec3 point) {
  const dvec4 clip = light.projection * light.view * dvec4(point, 1);
  return dvec3(clip) / clip.w;
}

// Every corner of the cube, and half of its side.
double farthest_corner(const LightView& light, dvec3 center, double half) {
  double farthest = 0;
  for (int i = 0; i < 8; ++i) {
    const dvec3 corner =
        center + half * dvec3((i & 1) ? 1 : -1, (i & 2) ? 1 : -1, (i & 4) ? 1 : -1);
    const dvec3 p = glm::abs(in_map(light, corner));
    farthest = std::max({farthest, p.x, p.y});
  }
  return farthest;
}

TEST(LightView,
     along_a_direction_is_as_wide_as_the_casters_and_reaches_from_the_first_to_the_floor) {
  const auto scene = cube_over_floor();
  const LightView light = light_view({0, 1, 0, 0}, scene, whole_content(scene));
  // The cube's side is 2, and the window is 1.01 times it: x' = 2/2.02 x, exactly but for rounding.
  EXPECT_NEAR(light.projection[0][0], 2 / 2.02, 1e-14);
  EXPECT_NEAR(light.projection[1][1], 2 / 2.02, 1e-14);
  EXPECT_NEAR(farthest_corner(light, {0, 3, 0}, 1), 1 / 1.01, 1e-14);
  // The cube's top at y = 4 is just inside of the near plane, the floor of the far one: each by
  // 1/1000 of the 4 metres between.
  EXPECT_NEAR(in_map(light, {0, 4.004, 0}).z, -1, 1e-14);
  EXPECT_NEAR(in_map(light, {0, -0.004, 0}).z, 1, 1e-14);
}

TEST(LightView, from_a_point_holds_the_casters_in_a_perspective_around_them) {
  const auto scene = cube_over_floor();
  const LightView light = light_view({0, 8, 0, 1}, scene, whole_content(scene));
  // From 8 the top of the cube, at 4 below, half-width 1, has the widest tangent: 1/4.
  EXPECT_NEAR(light.projection[0][0], 4 / 1.01, 1e-12);  // axis by 64 steps of an iteration
  EXPECT_NEAR(farthest_corner(light, {0, 3, 0}, 1), 1 / 1.01, 1e-12);
  EXPECT_NEAR(light.near, 4 - 0.004, 1e-12);
  EXPECT_NEAR(light.far, 8 + 0.004, 1e-12);
}

TEST(LightView, is_cut_to_what_the_camera_sees) {
  auto scene = cube_over_floor();
  scene.camera = {{0, 0.5, 3}, {0, 0, 0.5}, {0, 1, 0}, 10, 0.1, 4};
  const double whole = light_view({0, 1, 0, 0}, scene, whole_content(scene)).projection[0][0];
  const auto in_view = content_in_view(scene, scene.camera, 1);
  const LightView light = light_view({0, 1, 0, 0}, scene, in_view);
  EXPECT_GT(light.projection[0][0], 2 * whole);  // tan 5° · 4 m is a third of the cube's half-side
  // The point in the middle of the picture is shadowed and in the map.
  const dvec3 p = in_map(light, {0, 0, 0.5});
  EXPECT_LT(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}), 1);
}

TEST(LightView, leaves_out_casters_beyond_what_is_seen) {
  auto scene = cube_over_floor();
  scene.objects.push_back(object(scene::box(dvec3(2)), {0, -5, 0}, scene::Role::caster));
  scene.camera.far = 50;
  scene.objects.back().model[3] = dvec4(8, -5, 8, 1);  // under the floor: no receiver is behind it
  MapContent content;
  for (const auto& side :
       sides_of(hexahedron(scene::bounds(*scene.objects[0].mesh, scene.objects[0].model))))
    content.receivers.push_back(side);
  for (const dvec4& light : {dvec4(0, 1, 0, 0), dvec4(0, 8, 0, 1)}) {
    EXPECT_NEAR(farthest_corner(light_view(light, scene, content), {0, 3, 0}, 1), 1 / 1.01, 1e-12);
  }
}

TEST(LightView, holds_the_casters_of_a_subset_alone) {
  auto scene = cube_over_floor();
  scene.objects.push_back(object(scene::box(dvec3(1)), {6, 1, 0}, scene::Role::caster));
  auto content = whole_content(scene);
  content.casters = {2};
  EXPECT_NEAR(farthest_corner(light_view({0, 1, 0, 0}, scene, content), {6, 1, 0}, 0.5), 1 / 1.01,
              1e-13);
}

TEST(LightView, of_a_light_among_its_casters_is_refused) {
  auto scene = cube_over_floor();
  for (const dvec3& place : {dvec3(0, 3, 0), dvec3(0.5, 3.5, 0.25)})
    EXPECT_THROW(light_view(dvec4(place, 1), scene, whole_content(scene)), InputError);
  EXPECT_THROW(light_view({0, 0, 0, 0}, scene, whole_content(scene)), InputError);
}

TEST(LightView, of_one_plane_that_faces_the_light_has_some_depth) {
  scene::Scene scene;
  scene.objects = {object(scene::plane(2, 2), {0, 0, 0}, scene::Role::both)};
  for (const dvec4& light : {dvec4(0, 1, 0, 0), dvec4(0, 3, 0, 1)}) {
    const auto view = light_view(light, scene, whole_content(scene));
    EXPECT_GT(view.far, view.near);
    for (const dvec3& corner : {dvec3(1, 0, 1), dvec3(-1, 0, 1), dvec3(0, 0, 0)}) {
      const dvec3 p = glm::abs(in_map(view, corner));
      EXPECT_LT(std::max({p.x, p.y, p.z}), 1);
    }
  }
}

TEST(LightView, moves_with_the_world) {
  const auto here = cube_over_floor();
  const dvec3 away(1e6, -1e6, 1e6);
  const auto there = cube_over_floor(away);
  for (const double w : {0.0, 1.0}) {
    const dvec4 light(3, 8, 2, w);
    const auto a = light_view(light, here, whole_content(here));
    const auto b = light_view(light + dvec4(away * w, 0), there, whole_content(there));
    for (const dvec3& p : {dvec3(1, 4, 1), dvec3(-2, 0, 3), dvec3(0)}) {
      // 1e6 has an ulp of 1.2e-10; a few of them over a metre.
      EXPECT_LT(glm::length(in_map(a, p) - in_map(b, p + away)), 2e-9) << w;
    }
  }
}

// What matters is in the map: wherever the ray from a seen point to the light meets a caster's
// vertex, that vertex and the point are inside.
TEST(LightView, of_random_views_holds_every_shadowed_point_that_is_seen) {
  std::mt19937 engine(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  int tried = 0;
  for (int i = 0; i < 300; ++i) {
    auto scene = cube_over_floor();
    const dvec4 light = i % 2 ? dvec4(unit(engine) * 3, 1 + unit(engine) * 0.5, unit(engine) * 3, 0)
                              : dvec4(unit(engine) * 6, 7 + unit(engine) * 2, unit(engine) * 6, 1);
    scene.camera.eye = dvec3(unit(engine) * 9, 2 + unit(engine), 6 + unit(engine));
    scene.camera.target = dvec3(unit(engine), 1 + unit(engine), unit(engine));
    scene.camera.fovy = 50 + 30 * unit(engine);
    const LightView view = light_view(light, scene, content_in_view(scene, scene.camera, 1.3));
    const Hexahedron seen = frustum(scene.camera, 1.3, scene.camera.near, scene.camera.far);
    for (int k = 0; k < 40; ++k) {
      const dvec3 caster = dvec3(0, 3, 0) + dvec3(unit(engine), unit(engine), unit(engine));
      const dvec3 along = caster * light.w - dvec3(light);
      if (along.y >= 0) continue;
      const dvec3 receiver = caster + along * (caster.y / -along.y);
      bool inside = std::max(std::abs(receiver.x), std::abs(receiver.z)) < 10;
      for (const dvec4& plane : seen.planes)
        inside = inside && glm::dot(dvec3(plane), receiver) + plane.w > 0;
      if (!inside) continue;
      ++tried;
      const dvec3 a = glm::abs(in_map(view, caster)), b = glm::abs(in_map(view, receiver));
      EXPECT_LE(std::max({a.x, a.y, a.z, b.x, b.y, b.z}), 1) << i << ", " << k;
    }
  }
  EXPECT_GT(tried, 1000);
}

// From the point on the window's rim at the farthest depth to the light's edge, on the other side
// of its middle: where that passes the nearest depth the map with room ends, neither sooner nor
// later.
TEST(LightView, with_room_ends_where_the_light_s_edge_sees_the_rim) {
  const auto scene = cube_over_floor();
  const LightView middle = light_view({0, 7, 0, 1}, scene, whole_content(scene));
  for (const double radius : {0.0, 0.1, 1.0}) {
    const LightView view = with_room(middle, radius);
    const double per_tangent = std::max(middle.projection[0][0], middle.projection[1][1]);
    const double rim = middle.far / per_tangent;
    const double passes = glm::mix(-radius, rim, middle.near / middle.far);
    const double seen = glm::mix(radius, rim, middle.near / middle.far);
    const double ends = std::max(view.projection[0][0], view.projection[1][1]) / middle.near;
    EXPECT_NEAR(ends * seen, 1, 1e-12) << radius;  // some roundings
    EXPECT_LE(ends * passes, 1) << "and the other side's is inside";
    EXPECT_NEAR(ends * (seen - middle.near / per_tangent), edge_reach(view, radius), 1e-12);
  }
  EXPECT_THROW(with_room(middle, -1), InputError);
  EXPECT_THROW(with_room(middle, NAN), InputError);
  const LightView sun = light_view({0, 1, 0, 0}, scene, whole_content(scene));
  EXPECT_THROW(with_room(sun, 0.1), InputError);
}

}  // namespace
}  // namespace shadowlab::shadow
