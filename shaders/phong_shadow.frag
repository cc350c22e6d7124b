#version 330 core
// Phong's reflection model, or with `shadow` the one colour of a shadow.
in vec3 eye_position;
in vec3 eye_normal;
uniform bool shadow = false;
uniform vec4 light;           // eye space; w = 0: the direction toward it
uniform vec3 color;
uniform float ambient = 0.25;
uniform float specular = 0.2;
uniform float shininess = 32.0;
out vec4 fragment;

void main() {
  if (shadow) {
    fragment = vec4(color * ambient, 1.0);
    return;
  }
  vec3 to_eye = normalize(-eye_position);
  vec3 to_light = normalize(light.xyz - eye_position * light.w);
  vec3 n = normalize(eye_normal);
  if (dot(n, to_eye) < 0.0) n = -n;
  float diffuse = max(dot(n, to_light), 0.0);
  vec3 halfway = normalize(to_light + to_eye);
  float highlight = diffuse > 0.0 ? pow(max(dot(n, halfway), 0.0), shininess) : 0.0;
  fragment = vec4(color * (ambient + (1.0 - ambient) * diffuse) + specular * highlight, 1.0);
}
