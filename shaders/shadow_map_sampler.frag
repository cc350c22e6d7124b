#version 330 core
// The same comparison by the texture unit: sampler2DShadow under COMPARE_REF_TO_TEXTURE.
#include "lighting.glsl"
#include "receiver_plane.glsl"
in vec4 shadow_coord;
uniform sampler2DShadow shadow_map;
uniform float reach = 0.0;   // of a lookup on the map: half a texel, to its centre

void main() {
  vec4 c = shadow_coord;
  c.p -= c.q * climb(receiver_slope(c, dFdx(c), dFdy(c)), vec2(reach));
  float seen = textureProj(shadow_map, c);  // texture(shadow_map, c.stp / c.q)
  if (shadow_coord.q <= 0.0 || shadow_coord.p > shadow_coord.q) seen = 1.0;
  fragment = reflected(seen);
}
