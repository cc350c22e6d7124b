// Phong's vertex stage, and where the vertex is in the light's map. The matrix starts from the eye's
// space, not the world's, where a float holds too little of a vertex that is far from the origin.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 model_view;
uniform mat4 model_view_projection;
uniform mat3 normal_matrix;
uniform vec4 light;
uniform mat4 light_matrix;            // eye space to the map's (s, t, p, q)
uniform float normal_offset = 0.0;    // moves what is looked up along the normal, times sin θ
out vec3 eye_position;
out vec3 eye_normal;
out vec4 shadow_coord;
invariant gl_Position;

void main() {
  eye_position = (model_view * vec4(position, 1.0)).xyz;
  eye_normal = normal_matrix * normal;
  shadow_coord = light_matrix * vec4(eye_position, 1.0);
  if (normal_offset > 0.0) {
    vec3 n = normalize(eye_normal);
    vec3 to_light = normalize(light.xyz - eye_position * light.w);
    n *= sign(dot(n, to_light));
    // q is the distance along the light's axis under a perspective, else 1.
    float offset = normal_offset * length(cross(n, to_light)) * shadow_coord.q;
    shadow_coord = light_matrix * vec4(eye_position + n * offset, 1.0);
  }
  gl_Position = model_view_projection * vec4(position, 1.0);
}
