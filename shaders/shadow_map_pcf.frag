#version 330 core
// Percentage-closer filtering: the mean of comparisons at several places of the map, each of which the
// hardware blends over 2 × 2 texels where the map's filter is LINEAR.
#include "lighting.glsl"
#include "receiver_plane.glsl"
in vec4 shadow_coord;
uniform sampler2DShadow shadow_map;
uniform int taps = 1;              // of the first `taps` places
uniform vec3 places[64];           // x, y in texels, and a weight; the weights add up to 1
uniform float texel = 0.0;         // a texel's side in texture coordinates
uniform float reach = 0.0;        // of one lookup: half a texel to the nearest's centre, one to those of 2 × 2
uniform bool rotated = false;      // the pattern is turned by another angle at each pixel

void main() {
  vec3 stp = shadow_coord.stp / shadow_coord.q;
  vec2 slope = receiver_slope(shadow_coord, dFdx(shadow_coord), dFdy(shadow_coord));
  mat2 turn = mat2(1.0);
  if (rotated) {
    // Interleaved gradient noise: neighbours' angles are spread evenly (J. Jimenez, SIGGRAPH 2014).
    float angle = 6.2831853 * fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    turn = mat2(cos(angle), sin(angle), -sin(angle), cos(angle));
  }
  float seen = 0.0;
  for (int i = 0; i < taps; ++i) {
    vec2 way = turn * places[i].xy * texel;
    float depth = stp.p - climb(slope, abs(way) + reach);
    seen += places[i].z * texture(shadow_map, vec3(stp.st + way, depth));
  }
  if (shadow_coord.q <= 0.0 || stp.p > 1.0) seen = 1.0;
  fragment = reflected(seen);
}
