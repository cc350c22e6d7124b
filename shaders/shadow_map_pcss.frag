#version 330 core
// Percentage-closer soft shadows (R. Fernando, SIGGRAPH 2005 sketch). The light is a square, parallel to
// the map, of half-width s, or a sphere of radius s. What is at depth z before a receiver at depth r hides from it a part of the
// light that is seen in the map, on the plane at distance 1, within s (1/z - 1/r) of the receiver's own
// place. So: search the widest such square for blockers, take their mean depth, filter over the square
// that this depth gives. For one blocker parallel to the light that is the exact penumbra.
#include "lighting.glsl"
#include "receiver_plane.glsl"
in vec4 shadow_coord;
uniform sampler2D shadow_map;
uniform float half_width;          // of the light, metres
uniform vec2 per_tangent;          // texture coordinates for one metre on the plane at distance 1
uniform float near, far;
uniform int taps = 16;             // a side of the square: taps · taps in all
uniform bool sphere = false;

// The distance along the light's axis of a window depth under its perspective.
float distance_of(float depth) { return far * near / (far - depth * (far - near)); }

// Tap k, in [-1, 1]²: a grid for the square; for the sphere, points of its surface as seen from afar, in
// a spiral by the golden angle (their heights are spread evenly, by Archimedes).
vec2 place(int k) {
  if (!sphere) return (vec2(k % taps, k / taps) + 0.5) / float(taps) * 2.0 - 1.0;
  float height = (float(k) + 0.5) / float(taps * taps), angle = 2.39996323 * float(k);
  return sqrt(1.0 - height * height) * vec2(cos(angle), sin(angle));
}

void main() {
  vec3 stp = shadow_coord.stp / shadow_coord.q;
  // A wide filter must not take the plane itself for a blocker.
  vec2 slope = receiver_slope(shadow_coord, dFdx(shadow_coord), dFdy(shadow_coord));
  float receiver = shadow_coord.q;
  float seen = 1.0;
  if (receiver > near && stp.p < 1.0) {
    vec2 search = half_width * (1.0 / near - 1.0 / receiver) * per_tangent;
    float sum = 0.0;
    int blockers = 0;
    for (int k = 0; k < taps * taps; ++k) {
      vec2 step = place(k) * search;
      float stored = texture(shadow_map, stp.st + step).r;
      if (stored < stp.p + dot(slope, step)) {
        sum += distance_of(stored);
        ++blockers;
      }
    }
    if (blockers > 0) {
      vec2 width = half_width * max(0.0, float(blockers) / sum - 1.0 / receiver) * per_tangent;
      float lit = 0.0;
      for (int k = 0; k < taps * taps; ++k) {
        vec2 step = place(k) * width;
        lit += stp.p + dot(slope, step) <= texture(shadow_map, stp.st + step).r ? 1.0 : 0.0;
      }
      seen = lit / float(taps * taps);
    }
  }
  fragment = reflected(seen);
}
