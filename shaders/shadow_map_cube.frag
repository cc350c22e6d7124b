#version 330 core
// A point light's six faces in one cube map, or some of them as layers of an array. The vertex stage's matrix
// leads to the light's place with the world's axes, so shadow_coord is the way from the light.
#include "lighting.glsl"
#include "receiver_plane.glsl"
in vec4 shadow_coord;
uniform samplerCubeShadow shadow_map;
uniform sampler2DArrayShadow shadow_maps;
uniform bool in_cube = true;
uniform int layers[6];       // of +x, -x, +y, -y, +z, -z; -1: nothing is in shadow there
uniform float near;
uniform float far;
uniform float reach = 0.0;  // of a lookup, on the plane at distance 1 of a face

// What texture(samplerCubeShadow) does (OpenGL 4.5, table 8.19): the face of the largest coordinate, and
// the two others over it as s and t.
float seen_in_layers(vec3 way, float depth) {
  vec3 sizes = abs(way);
  int axis = sizes.x >= sizes.y && sizes.x >= sizes.z ? 0 : sizes.y >= sizes.z ? 1 : 2;
  bool back = way[axis] < 0.0;
  int layer = layers[2 * axis + int(back)];
  if (layer < 0) return 1.0;
  vec2 st = axis == 0 ? vec2(back ? way.z : -way.z, -way.y)
          : axis == 1 ? vec2(way.x, back ? -way.z : way.z) : vec2(back ? -way.x : way.x, -way.y);
  return texture(shadow_maps, vec4(st / sizes[axis] * 0.5 + 0.5, float(layer), depth));
}

void main() {
  vec3 way = shadow_coord.xyz;
  // A face's depth is measured along its axis, which is the largest of the three.
  vec3 sizes = abs(way);
  float along = max(max(sizes.x, sizes.y), sizes.z);
  // Floats tell a place by some 10 roundings of 2^-24 of its way from the eye, which may be far longer than
  // that from the light: so it is taken for nearer.
  float nearer = along - exp2(-20.0) * length(eye_position);
  float depth = far * (nearer - near) / ((far - near) * nearer);
  // On the face as a map: s and t are the two other axes over this one, and p is the depth.
  mat3 to_face = sizes.x == along ? mat3(0, 0, 1, 1, 0, 0, 0, 1, 0)
               : sizes.y == along ? mat3(0, 1, 0, 0, 0, 1, 1, 0, 0) : mat3(1, 0, 0, 0, 1, 0, 0, 0, 1);
  vec3 c = to_face * way, x = to_face * dFdx(way), y = to_face * dFdy(way);
  float front = sign(c.z), scale = far / (far - near);
  vec2 slope = receiver_slope(vec4(c.xy, scale * (along - near), along),
                              vec4(x.xy, front * x.z * vec2(scale, 1.0)),
                              vec4(y.xy, front * y.z * vec2(scale, 1.0)));
  depth -= climb(slope, vec2(reach));
  float seen = along < near ? 1.0 : in_cube ? texture(shadow_map, vec4(way, depth)) : seen_in_layers(way, depth);
  if (along > far) seen = 1.0;
  fragment = reflected(seen);
}
