#version 330 core
// The lecture's comparison: the fragment's distance from the light with the map's.
#include "lighting.glsl"
#include "receiver_plane.glsl"
in vec4 shadow_coord;
uniform sampler2D shadow_map;
uniform float bias = 0.0;
uniform float reach = 0.0;   // of a lookup on the map: half a texel, to its centre

void main() {
  vec2 st = shadow_coord.st / shadow_coord.q;
  float true_depth = shadow_coord.p / shadow_coord.q;
  true_depth -= climb(receiver_slope(shadow_coord, dFdx(shadow_coord), dFdy(shadow_coord)), vec2(reach));
  float stored_depth = texture(shadow_map, st).r;
  float seen = true_depth - bias <= stored_depth ? 1.0 : 0.0;
  // Behind the light, where q is negative, and farther than the map reaches it knows nothing.
  if (shadow_coord.q <= 0.0 || true_depth > 1.0) seen = 1.0;
  fragment = reflected(seen);
}
