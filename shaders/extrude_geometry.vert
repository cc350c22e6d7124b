#version 330 core
// Each vertex where it is and where the light pushes it, once for all triangles around it.
layout(location = 0) in vec3 position;
uniform vec4 volume_light;  // model space
uniform mat4 model_view_projection;
out vec3 corner;
out vec4 pushed;
invariant gl_Position;

void main() {
  corner = position;
  pushed = model_view_projection * vec4(position * volume_light.w - volume_light.xyz, 0.0);
  gl_Position = model_view_projection * vec4(position, 1.0);
}
