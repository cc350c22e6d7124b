#version 330 core
// Phong's vertex stage: where a fragment is on the map its own triangle says, not an interpolation.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 model_view;
uniform mat4 model_view_projection;
uniform mat3 normal_matrix;
out vec3 eye_position;
out vec3 eye_normal;
invariant gl_Position;

void main() {
  eye_position = (model_view * vec4(position, 1.0)).xyz;
  eye_normal = normal_matrix * normal;
  gl_Position = model_view_projection * vec4(position, 1.0);
}
