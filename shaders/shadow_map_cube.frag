#version 330 core
// A point light's six faces in one cube map. The vertex stage's matrix leads to the light's place with
// the world's axes, so shadow_coord is the way from the light.
#include "lighting.glsl"
in vec4 shadow_coord;
uniform samplerCubeShadow shadow_map;
uniform float near;
uniform float far;

void main() {
  vec3 way = shadow_coord.xyz;
  // A face's depth is measured along its axis, which is the largest of the three.
  vec3 sizes = abs(way);
  float along = max(max(sizes.x, sizes.y), sizes.z);
  float depth = far * (along - near) / ((far - near) * along);
  float seen = along < near ? 1.0 : texture(shadow_map, vec4(way, depth));
  if (along > far) seen = 1.0;
  fragment = reflected(seen);
}
