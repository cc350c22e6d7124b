#version 330 core
// The visibility alone, for `shadowlab check`: what is drawn without light is dark.
uniform vec3 color;
uniform float ambient;
out vec4 fragment;

void main() { fragment = vec4(vec3(0.0), 1.0); }
