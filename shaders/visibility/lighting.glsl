// The visibility alone, for `shadowlab check`: white where the light reaches, black where not. A
// caster's side that is turned from the light is in its own shadow, by the face's own plane.
in vec3 eye_position;
in vec3 eye_normal;
uniform vec4 light;
uniform vec3 color;
uniform float ambient;
uniform float specular;
uniform float shininess;
uniform bool casts = false;
out vec4 fragment;

vec4 reflected(float seen) {
  vec3 toward_eye = cross(dFdx(eye_position), dFdy(eye_position));  // of the side that is seen
  vec3 to_light = light.xyz - eye_position * light.w;
  if (casts && dot(toward_eye, to_light) <= 0.0) seen = 0.0;
  return vec4(vec3(seen), 1.0);
}

vec4 tinted(float seen, vec3 tint) { return reflected(seen); }
