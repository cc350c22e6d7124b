#version 330 core
// One step of jump flooding: each pixel takes what is nearest to it of what it has and what eight
// others have, `stride` pixels away. After steps of 64, 32 … 1 that is nearly always the nearest of
// all within reach. (G. Rong, T.-S. Tan, Jump Flooding in GPU with Applications to Voronoi Diagram
// and Distance Transform, 2006.)
uniform sampler2D surface;   // eye space
uniform sampler2D outlines;  // points of outlines, eye space; w = 0: none
uniform int stride;
out vec4 nearest;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec3 p = texelFetch(surface, pixel, 0).xyz;
  float least = 1e30;
  nearest = vec4(0.0);
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) {
      ivec2 other = pixel + stride * ivec2(x, y);
      if (any(lessThan(other, ivec2(0))) || any(greaterThanEqual(other, textureSize(surface, 0)))) continue;
      vec4 found = texelFetch(outlines, other, 0);
      float d = dot(found.xyz - p, found.xyz - p);
      if (found.w == 0.0 || d >= least) continue;
      least = d;
      nearest = found;
    }
  }
}
