#version 330 core
// The lecture's one program for a caster and for its shadow: phong's vertex stage, and the shadow's
// matrix comes in as part of the model matrix. Below its plane a caster throws no shadow: there a
// clip distance cuts.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 model_view;
uniform mat4 model_view_projection;
uniform mat3 normal_matrix;
// The plane in the caster's own space, positive toward the light; unset, all is above it.
uniform vec4 above = vec4(0.0, 0.0, 0.0, 1.0);
out vec3 eye_position;
out vec3 eye_normal;
invariant gl_Position;

void main() {
  eye_position = (model_view * vec4(position, 1.0)).xyz;
  eye_normal = normal_matrix * normal;
  gl_Position = model_view_projection * vec4(position, 1.0);
  gl_ClipDistance[0] = dot(above, vec4(position, 1.0));
}
