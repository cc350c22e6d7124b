#version 330 core
// The quad [-1, 1]², drawn without matrices.
layout(location = 0) in vec3 position;

void main() { gl_Position = vec4(position, 1.0); }
