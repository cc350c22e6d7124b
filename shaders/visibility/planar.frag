#version 330 core
// The visibility alone, for `shadowlab check`: a shadow is black, whatever its colour.
uniform vec3 color;
out vec4 fragment;

void main() { fragment = vec4(0.0, 0.0, 0.0, 1.0); }
