#version 330 core
// A quad that is in clip space already.
layout(location = 0) in vec3 position;

void main() { gl_Position = vec4(position, 1.0); }
