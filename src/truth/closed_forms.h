// Visibility of a light in closed form: what every soft technique and the tracer are held against.
//
// All lengths in one unit (metres); visibility is the share of the light's area that is seen, 0 in
// the umbra and 1 where lit. The receiver is the plane y = 0, the caster lies in the plane y = h,
// the light in the plane y = H, 0 ≤ h < H, and light, caster and receiver are parallel. A receiver
// point x and a light point l are joined by a segment that crosses the caster's plane at
//     c = x + (l - x) h/H.
// So c lies past an edge at e exactly when l lies past  (e - x (1 - h/H)) H/h: the edge, seen from
// x, cuts the light at a place that moves linearly with x. Everything below is that one line.
#pragma once

#include <glm/glm.hpp>

namespace shadowlab::truth {

/// The heights of the caster (h) and of the light (H) over the receiver.
/// Every function below throws InputError unless 0 ≤ h < H.
struct Heights {
  double caster = 0;
  double light = 1;
};

/// p = s h/(H-h): the half-width, on the receiver, of the penumbra of an edge under a light whose
/// half-width across the edge is s ≥ 0. (By similar triangles from the edge: light side H-h,
/// receiver side h.) Occluder → receiver or light → point: 0, the hard shadow.
double penumbra_half_width(double light_half_width, Heights heights);

/// Where the light at x = l throws the edge at x = e onto the receiver: e + (e - l) h/(H-h).
double projected_edge(double edge, double light, Heights heights);

/// A half-plane caster that lies on one side of its edge, under a rectangle light with
/// a side along the edge. `distance` is from the projected edge of the light's centre, positive on
/// the lit side; p as above. A linear ramp: clamp((d + p) / 2p); the step d ≥ 0 (1/2 at 0) where p
/// = 0.
double half_plane_under_rectangle(double distance, double penumbra_half_width);

/// The same under a disk (p from its radius): the share of a disk of radius 1 on the lit side of a
/// chord at t = d/p, 1/2 + (t √(1-t²) + asin t)/π.
double half_plane_under_disk(double distance, double penumbra_half_width);

/// The same under a sphere whose surface is sampled uniformly (see shadow::samples), seen from
/// afar: by Archimedes a zone's area is proportional to its height, so it is the rectangle's ramp.
/// Off by O(radius / distance to the light), since the tangent planes are not parallel.
double half_plane_under_sphere(double distance, double penumbra_half_width);

/// A rectangle caster's shadow under a rectangle light with parallel sides: the light's part hidden
/// is a rectangle, so the hidden share is a product, one factor for each axis, and
/// visibility = 1 - cover_x · cover_z. `receiver` is the point (x, z), the caster spans [low,
/// high], the light is center ± half. At one corner of a large caster it is 1 - (1-r_x)(1-r_z) with
/// r the ramps of its two edges.
double rectangle_under_rectangle(glm::dvec2 receiver, glm::dvec2 caster_low, glm::dvec2 caster_high,
                                 glm::dvec2 light_center, glm::dvec2 light_half, Heights heights);

/// A disk caster of radius `caster` centred under a disk light of radius `light`: rings around the
/// axis on the receiver.
struct DiskShadow {
  double umbra = 0;     ///< radius within which nothing of the light is seen; 0 where there is none
  double antumbra = 0;  ///< radius within which the whole caster is seen before the light; else 0
  double penumbra = 0;  ///< radius beyond which all of the light is seen
};

/// From the two families of tangents: with k = h/(H-h), the caster's rim at ±R is thrown to
/// R + (R ∓ s) k. The umbra ends at R + (R - s) k and is empty where that is ≤ 0 (a light larger
/// than the caster, high enough over it); then within s k - R (1 + k) the caster is seen whole
/// before the light. The penumbra ends at R + (R + s) k.
DiskShadow disk_under_disk(double caster_radius, double light_radius, Heights heights);

/// Visibility for disk_under_disk at `distance` from the axis: 1 minus the overlap of the light
/// (radius s) with the caster thrown back onto the light's plane (radius R H/h, centre distance d
/// (H-h)/h), a lens of two circular segments, over π s². h = 0 gives the step at R.
double disk_under_disk(double distance, double caster_radius, double light_radius, Heights heights);

}  // namespace shadowlab::truth
