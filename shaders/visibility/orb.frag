#version 330 core
// The visibility alone, for `shadowlab check`: the light is no surface.
uniform vec3 color;
uniform sampler2D covered;
uniform float points = 0.0;
out vec4 fragment;

void main() { discard; }
