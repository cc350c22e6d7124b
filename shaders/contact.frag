#version 330 core
// How far from the light the edge is that throws this side. A point X of the side is E + t (E - L),
// with E on the edge: then X - L is (E - L) / w. Of all sides at a pixel the one that is nearest to
// what is seen stays, by the depth test on the distance between the two.
in vec4 eye;
uniform vec4 light;         // eye space
uniform sampler2D surface;  // what is seen, eye space
uniform sampler2D hard;     // 1 where the centre of the light is seen
out vec4 outline;           // where the side is at this pixel, eye space; and that distance

// Sides that end within a shadow, behind another's, have no part in its outline.
bool near_outline(ivec2 pixel) {
  float here = texelFetch(hard, pixel, 0).r;
  ivec2 last = textureSize(hard, 0) - 1;
  for (int i = 0; i < 12; ++i) {
    float a = float(i) * 0.5235987755982988;
    ivec2 other = clamp(pixel + ivec2(round(float(1 + i % 3) * vec2(cos(a), sin(a)))), ivec2(0), last);
    if (texelFetch(surface, other, 0).w > 0.0 && texelFetch(hard, other, 0).r != here) return true;
  }
  return false;
}

void main() {
  vec4 seen = texelFetch(surface, ivec2(gl_FragCoord.xy), 0);
  if (seen.w == 0.0 || !near_outline(ivec2(gl_FragCoord.xy))) discard;
  vec3 side = eye.xyz / eye.w;
  float gap = abs(side.z - seen.z);
  outline = vec4(side, length(eye.xyz - light.xyz * eye.w));
  gl_FragDepth = gap / (gap - seen.z);
}
