#version 330 core
// The visibility alone, for `shadowlab check`: what is lit is white, and shadows are drawn over it.
in vec3 reflected;
out vec4 fragment;

void main() { fragment = vec4(1.0); }
