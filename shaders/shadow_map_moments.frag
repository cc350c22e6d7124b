#version 330 core
// How much of a filtered area is lit, from the moments of its depths: an upper bound, exact where the
// area holds two depths, as it does at the edge of one shadow. Where shadows of several depths overlap
// the bound is loose, and light leaks.
#include "lighting.glsl"
#include "moments.glsl"
in vec4 shadow_coord;
uniform sampler2D shadow_map;
uniform float near, far;
uniform bool perspective;
uniform float least_variance = 1e-6;

// Chebyshev's one-sided inequality: how much of a distribution can be at t or beyond
// (W. Donnelly, A. Lauritzen, Variance Shadow Maps, I3D 2006).
float chebyshev(vec2 moments, float t, float least) {
  float variance = max(moments.y - moments.x * moments.x, least);
  float beyond = t - moments.x;
  return beyond <= 0.0 ? 1.0 : variance / (variance + beyond * beyond);
}

// The largest part at t or beyond that four moments allow: the distribution on three depths, t among
// them, that has these moments, by the Cholesky factors of their Hankel matrix (C. Peters, R. Klein,
// Moment Shadow Mapping, I3D 2015).
float hamburger(vec4 m, float t) {
  m = mix(m, vec4(0.5), 3e-5);                      // keeps the matrix positive in floats
  float d22 = max(m.y - m.x * m.x, 1e-9);
  float l32_d22 = m.z - m.x * m.y;
  float l32 = l32_d22 / d22;
  float d33_d22 = max((m.w - m.y * m.y) * d22 - l32_d22 * l32_d22, 1e-9);
  vec3 c = vec3(1.0, t, t * t);
  c.y -= m.x;                                       // forward through L
  c.z -= m.y + l32 * c.y;
  c.y /= d22;                                       // D
  c.z *= d22 / d33_d22;
  c.y -= l32 * c.z;                                 // back through L transposed
  c.x -= dot(c.yz, m.xy);
  // The other two depths: the roots of c.z z² + c.y z + c.x, without cancellation. At the edge of one
  // shadow t is nearly all that is needed beside one of them, and the other is far away.
  float h = -0.5 * (c.y + (c.y < 0.0 ? -1.0 : 1.0) * sqrt(max(c.y * c.y - 4.0 * c.z * c.x, 0.0)));
  float one = clamp(c.x / h, -1e4, 1e4), other = clamp(h / c.z, -1e4, 1e4);
  float first = min(one, other), second = max(one, other);
  float dark = 0.0;
  if (second < t) {
    dark = 1.0 + (first * second - m.x * (first + second) + m.y) / ((second - t) * (t - first));
  } else if (first < t) {
    dark = (t * second - m.x * (t + second) + m.y) / ((second - first) * (t - first));
  }
  return 1.0 - clamp(dark, 0.0, 1.0);
}

void main() {
  vec3 stp = shadow_coord.stp / shadow_coord.q;
  float distance = perspective ? shadow_coord.q : near + stp.p * (far - near);
  float t = (distance - near) / (far - near);
  vec4 moments = texture(shadow_map, stp.st);
  float seen;
  if (kind == 0) {
    seen = chebyshev(moments.xy, t, least_variance);
  } else if (kind == 1) {
    // A depth's slope under the warp scales the least variance.
    vec2 w = moments_of(t).xz, slope = warp * w;
    seen = min(chebyshev(moments.xy, w.x, least_variance * slope.x * slope.x),
               chebyshev(moments.zw, w.y, least_variance * slope.y * slope.y));
  } else {
    seen = hamburger(moments, t - 1e-3);
  }
  bool outside = any(lessThan(stp.st, vec2(0.0))) || any(greaterThan(stp.st, vec2(1.0)));
  if (shadow_coord.q <= 0.0 || outside || t > 1.0) seen = 1.0;
  fragment = reflected(seen);
}
