#version 330 core
// For passes whose colours are masked.
out vec4 fragment;

void main() { fragment = vec4(1.0); }
