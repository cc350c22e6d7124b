#version 330 core
// What phong leaves where lit = 0, to the bit: the ambient part alone, and no light to compute.
uniform vec3 color;
uniform float ambient = 0.25;
out vec4 fragment;

void main() { fragment = vec4(color * ambient, 1.0); }
