#version 330 core
// The share of the light that a caster hides, whatever the picture shows of it.
uniform vec3 color;
out vec4 fragment;

void main() { fragment = vec4(color, 1.0); }
