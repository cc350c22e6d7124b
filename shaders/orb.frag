#version 330 core
// It shines by itself. Of a light that is jittered a pixel may show some of its places alone: how many
// cover it, and of how many; 0 points: it is there, all of it.
uniform vec3 color;
uniform sampler2D covered;
uniform float points = 0.0;
out vec4 fragment;

void main() {
  float share = points > 0.0 ? texelFetch(covered, ivec2(gl_FragCoord.xy), 0).r / points : 1.0;
  fragment = vec4(color, share);
}
