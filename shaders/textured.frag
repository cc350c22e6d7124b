#version 330 core
// A texture, lit diffusely from both sides.
in vec3 eye_position;
in vec3 eye_normal;
in vec2 coordinate;
uniform sampler2D image;
uniform vec4 light;           // eye space; w = 0: the direction toward it
uniform float ambient = 0.25;
uniform float lit = 1.0;      // 0: what a shadow leaves, the ambient part alone
out vec4 fragment;

void main() {
  vec3 to_light = normalize(light.xyz - eye_position * light.w);
  vec3 n = normalize(eye_normal);
  if (dot(n, eye_position) > 0.0) n = -n;
  float diffuse = max(dot(n, to_light), 0.0);
  fragment = vec4(texture(image, coordinate).rgb * (ambient + lit * (1.0 - ambient) * diffuse), 1.0);
}
