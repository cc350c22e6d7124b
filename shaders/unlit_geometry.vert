#version 330 core
layout(location = 0) in vec3 position;
uniform mat4 model_view_projection;
out vec3 corner;
invariant gl_Position;

void main() {
  corner = position;
  gl_Position = model_view_projection * vec4(position, 1.0);
}
