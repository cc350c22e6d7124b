#version 330 core
// The visibility alone, for `shadowlab check`: what is lit is white, and shadows are drawn over it,
// or the share of the light that is hidden is taken from it.
in vec3 reflected;
uniform vec3 color;
uniform float ambient = 0.25;
uniform sampler2D hidden;
uniform float points = 0.0;
out vec4 fragment;

void main() {
  float unseen = points > 0.0 ? texelFetch(hidden, ivec2(gl_FragCoord.xy), 0).r / points : 0.0;
  fragment = vec4(vec3(1.0 - unseen), 1.0);
}
