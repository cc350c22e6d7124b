// Phong's reflection model in eye space; surfaces are lit from both sides. What a fragment shader of
// shadows includes: it says how much of the light a fragment sees, and this says its colour.
in vec3 eye_position;
in vec3 eye_normal;
uniform vec4 light;           // eye space; w = 0: the direction toward it
uniform vec3 color;
uniform float ambient = 0.25;
uniform float specular = 0.2;
uniform float shininess = 32.0;
uniform bool casts = false;   // the object throws shadows, and so its sides turned away are in its own
out vec4 fragment;

vec4 reflected(float seen) {
  vec3 to_eye = normalize(-eye_position);
  vec3 to_light = normalize(light.xyz - eye_position * light.w);
  vec3 n = normalize(eye_normal);
  if (dot(n, to_eye) < 0.0) n = -n;
  float diffuse = max(dot(n, to_light), 0.0);  // 0 on the sides that are turned away
  vec3 halfway = normalize(to_light + to_eye);
  float highlight = diffuse > 0.0 ? pow(max(dot(n, halfway), 0.0), shininess) : 0.0;
  return vec4(color * (ambient + seen * (1.0 - ambient) * diffuse) + seen * specular * highlight, 1.0);
}

// The same with the surface's colour mixed with another, to show what a fragment was shaded by.
vec4 tinted(float seen, vec3 tint) { return reflected(seen) * vec4(mix(vec3(1.0), tint, 0.5), 1.0); }
