#version 330 core
// The distance along the light's axis, 0 at the map's near plane and 1 at its far one.
layout(location = 0) in vec3 position;
uniform mat4 model_view;
uniform mat4 model_view_projection;
uniform float near, far;
out float depth;
invariant gl_Position;

void main() {
  depth = (-(model_view * vec4(position, 1.0)).z - near) / (far - near);
  gl_Position = model_view_projection * vec4(position, 1.0);
}
