#version 330 core
// Phong's vertex stage with texture coordinates.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
uniform mat4 model_view;
uniform mat4 model_view_projection;
uniform mat3 normal_matrix;
uniform vec2 repeats = vec2(1.0);
out vec3 eye_position;
out vec3 eye_normal;
out vec2 coordinate;
invariant gl_Position;

void main() {
  eye_position = (model_view * vec4(position, 1.0)).xyz;
  eye_normal = normal_matrix * normal;
  coordinate = uv * repeats;
  gl_Position = model_view_projection * vec4(position, 1.0);
}
