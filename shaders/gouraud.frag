#version 330 core
in vec3 reflected;
out vec4 fragment;

void main() { fragment = vec4(reflected, 1.0); }
