#version 330 core
// A cube of shadow maps as it is listed: the fragment's depth, as floats have it, and the map's.
#include "lighting.glsl"
in vec4 shadow_coord;
uniform samplerCubeShadow shadow_map;
uniform float near;
uniform float far;
// What the recipe sets besides.
uniform sampler2DArrayShadow shadow_maps;
uniform bool in_cube;
uniform int layers[6];
uniform float reach;

void main() {
  vec3 sizes = abs(shadow_coord.xyz);
  float along = max(max(sizes.x, sizes.y), sizes.z);
  fragment = reflected(texture(shadow_map, vec4(shadow_coord.xyz, far * (along - near) / ((far - near) * along))));
}
