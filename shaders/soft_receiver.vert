#version 330 core
// A rectangle of its model's plane y = 0 and where in it a vertex is, from (0, 0) to (1, 1).
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 model_view;
uniform mat4 model_view_projection;
uniform mat3 normal_matrix;
uniform vec2 corner;  // the least x and z
uniform vec2 sides;
out vec3 eye_position;
out vec3 eye_normal;
out vec2 coordinate;
invariant gl_Position;

void main() {
  eye_position = (model_view * vec4(position, 1.0)).xyz;
  eye_normal = normal_matrix * normal;
  coordinate = (position.xz - corner) / sides;
  gl_Position = model_view_projection * vec4(position, 1.0);
}
