#version 330 core
// Lighting at the vertices, as fixed-function GL did it: between them colours are interpolated, so what
// a light does in the middle of a large triangle is lost. Surfaces are lit from both sides.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 model_view;
uniform mat4 model_view_projection;
uniform mat3 normal_matrix;
uniform vec4 light;  // eye space; w = 0: the direction toward it
uniform vec3 color;
uniform float ambient = 0.25;
uniform float specular = 0.2;
uniform float shininess = 32.0;
out vec3 reflected;
invariant gl_Position;

void main() {
  vec3 eye_position = (model_view * vec4(position, 1.0)).xyz;
  vec3 to_eye = normalize(-eye_position);
  vec3 to_light = normalize(light.xyz - eye_position * light.w);
  vec3 n = normalize(normal_matrix * normal);
  if (dot(n, to_eye) < 0.0) n = -n;
  float diffuse = max(dot(n, to_light), 0.0);
  vec3 halfway = normalize(to_light + to_eye);
  float highlight = diffuse > 0.0 ? pow(max(dot(n, halfway), 0.0), shininess) : 0.0;
  reflected = color * (ambient + (1.0 - ambient) * diffuse) + specular * highlight;
  gl_Position = model_view_projection * vec4(position, 1.0);
}
