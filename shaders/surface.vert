#version 330 core
// What is seen, for passes that need to know where it is: eye space.
layout(location = 0) in vec3 position;
uniform mat4 model_view;
uniform mat4 model_view_projection;
out vec3 eye_position;
invariant gl_Position;

void main() {
  eye_position = (model_view * vec4(position, 1.0)).xyz;
  gl_Position = model_view_projection * vec4(position, 1.0);
}
