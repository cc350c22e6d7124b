#version 330 core
// The visibility alone, for `shadowlab check`: the light is no surface.
uniform vec3 color;
out vec4 fragment;

void main() { discard; }
