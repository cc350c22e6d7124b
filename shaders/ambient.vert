#version 330 core
// Positions alone, as phong has them.
layout(location = 0) in vec3 position;
uniform mat4 model_view_projection;
invariant gl_Position;

void main() { gl_Position = model_view_projection * vec4(position, 1.0); }
