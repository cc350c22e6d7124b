// What a moment map stores of a depth t in [0, 1], so that it can be averaged.
uniform int kind;                  // 0: variance, 1: exponential variance, 2: four moments
const float warp = 20.0;           // e^(2 · 20) keeps 32-bit floats in range and precise enough

vec4 moments_of(float t) {
  if (kind == 1) {
    float up = exp(warp * t), down = -exp(-warp * t);
    return vec4(up, up * up, down, down * down);
  }
  return vec4(t, t * t, t * t * t, t * t * t * t);
}
