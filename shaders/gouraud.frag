#version 330 core
in vec3 reflected;
uniform vec3 color;
uniform float ambient = 0.25;
// How many of the light's points are hidden from each pixel, and of how many; 0: it is not asked.
uniform sampler2D hidden;
uniform float points = 0.0;
out vec4 fragment;

void main() {
  float unseen = points > 0.0 ? texelFetch(hidden, ivec2(gl_FragCoord.xy), 0).r / points : 0.0;
  fragment = vec4(mix(reflected, color * ambient, unseen), 1.0);
}
