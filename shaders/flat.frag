#version 330 core
// One colour, unlit.
uniform vec3 color;
uniform float alpha = 1.0;
out vec4 fragment;

void main() { fragment = vec4(color, alpha); }
