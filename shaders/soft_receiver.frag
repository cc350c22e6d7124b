#version 330 core
// A receiver with a texture that says which share of the light is hidden from it.
#include "lighting.glsl"
in vec2 coordinate;
uniform sampler2D hidden;

void main() { fragment = reflected(1.0 - texture(hidden, coordinate).r); }
