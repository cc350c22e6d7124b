#version 330 core
// Phong's reflection model; surfaces are lit from both sides, as open ones are seen from both.
in vec3 eye_position;
in vec3 eye_normal;
uniform vec4 light;           // eye space; w = 0: the direction toward it
uniform vec3 color;
uniform float ambient = 0.25;
uniform float specular = 0.2;
uniform float shininess = 32.0;
uniform float lit = 1.0;      // 0: what a shadow leaves, the ambient part alone
uniform bool lit_by_texture = false;  // lit comes from a picture of the visibility instead
uniform sampler2D visibility;
out vec4 fragment;

void main() {
  vec3 to_eye = normalize(-eye_position);
  vec3 to_light = normalize(light.xyz - eye_position * light.w);
  vec3 n = normalize(eye_normal);
  if (dot(n, to_eye) < 0.0) n = -n;
  float diffuse = max(dot(n, to_light), 0.0);
  vec3 halfway = normalize(to_light + to_eye);
  float highlight = diffuse > 0.0 ? pow(max(dot(n, halfway), 0.0), shininess) : 0.0;
  float seen = lit_by_texture ? texelFetch(visibility, ivec2(gl_FragCoord.xy), 0).r : lit;
  vec3 reflected = color * (ambient + seen * (1.0 - ambient) * diffuse) + seen * specular * highlight;
  fragment = vec4(reflected, 1.0);
}
