#version 330 core
// Several maps, one a layer; which of them a fragment reads is what the ways of cascading differ in.
#include "lighting.glsl"
#include "receiver_plane.glsl"
uniform sampler2DArrayShadow shadow_maps;
uniform mat4 light_matrices[4];     // eye space to each map's (s, t, p, q)
uniform float ends[4];              // how far along the view each part reaches
uniform int layers[4] = int[4](0, 1, 2, 3);  // of each map; -1: nothing is in shadow there
uniform int count = 1;
uniform int choice = 0;             // 0: by depth; 1: the first that holds it; 2: all of them
uniform float reach = 0.0;          // of a lookup on a map: half a texel, to its centre
uniform bool tint = false;
const vec3 tints[4] = vec3[4](vec3(1.0, 0.35, 0.3), vec3(0.4, 0.9, 0.35), vec3(0.35, 0.5, 1.0), vec3(1.0, 0.85, 0.25));

vec3 x, y;  // the fragment's steps to the next pixels, eye space

vec4 coordinate(int i) { return light_matrices[i] * vec4(eye_position, 1.0); }

bool holds(vec4 c) {
  return c.q > 0.0 && all(greaterThan(c.stp, vec3(0.0))) && all(lessThan(c.stp, vec3(c.q)));
}

float seen_by(int i) {
  if (layers[i] < 0) return 1.0;
  vec4 c = coordinate(i);
  if (c.q <= 0.0 || c.p > c.q) return 1.0;  // behind the light, or farther than the map knows
  vec2 slope = receiver_slope(c, light_matrices[i] * vec4(x, 0.0), light_matrices[i] * vec4(y, 0.0));
  return texture(shadow_maps, vec4(c.st / c.q, float(layers[i]), c.p / c.q - climb(slope, vec2(reach))));
}

void main() {
  x = dFdx(eye_position);
  y = dFdy(eye_position);
  float seen = 1.0;
  int used = count;
  if (choice == 0) {
    for (used = 0; used < count && -eye_position.z > ends[used]; ++used) {}
    if (used < count) seen = seen_by(used);
  } else if (choice == 1) {
    for (used = 0; used < count && !holds(coordinate(used)); ++used) {}
    if (used < count) seen = seen_by(used);
  } else {
    // Each map has other casters: what any of them shadows is in shadow.
    for (int i = 0; i < count; ++i) {
      float by_group = seen_by(i);
      if (by_group < seen) {
        seen = by_group;
        used = i;
      }
    }
  }
  fragment = tint && used < count ? tinted(seen, tints[used]) : reflected(seen);
}
