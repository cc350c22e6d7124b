#version 330 core
// The same comparison by the texture unit: sampler2DShadow under COMPARE_REF_TO_TEXTURE.
#include "lighting.glsl"
in vec4 shadow_coord;
uniform sampler2DShadow shadow_map;

void main() {
  float seen = textureProj(shadow_map, shadow_coord);  // texture(shadow_map, shadow_coord.stp / q)
  if (shadow_coord.q <= 0.0 || shadow_coord.p > shadow_coord.q) seen = 1.0;
  fragment = reflected(seen);
}
