#version 330 core
// How far the means of two halves of the light's points differ: the square, summed over a block of
// pixels for each fragment.
uniform sampler2D counted;  // from how many of all points a pixel is hidden
uniform sampler2D before;   // from how many of the first half
uniform float points;       // all
uniform int side;           // of a block, in pixels
out vec4 fragment;

void main() {
  ivec2 first = ivec2(gl_FragCoord.xy) * side, last = min(first + side, textureSize(counted, 0));
  float sum = 0.0;
  for (int y = first.y; y < last.y; ++y) {
    for (int x = first.x; x < last.x; ++x) {
      float all = texelFetch(counted, ivec2(x, y), 0).r, half_of_them = texelFetch(before, ivec2(x, y), 0).r;
      float difference = (all - 2.0 * half_of_them) / (0.5 * points);
      sum += difference * difference;
    }
  }
  fragment = vec4(sum, 0.0, 0.0, 1.0);
}
