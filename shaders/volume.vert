#version 330 core
// A shadow volume: vertices (p, 1) stay, vertices (p, 0) are pushed away from the light, to infinity
// (p * L.w - L.xyz, w = 0) or by a distance. Vertices that stay are transformed exactly as the
// scene's own, so that a cap has the depth of the surface that it covers.
layout(location = 0) in vec4 position;
uniform vec4 volume_light;        // model space
uniform float volume_extrusion;   // metres; 0: to infinity
uniform mat4 model_view_projection;
invariant gl_Position;

void main() {
  vec4 p = vec4(position.xyz, 1.0);
  if (position.w == 0.0) {
    vec3 away = position.xyz * volume_light.w - volume_light.xyz;
    p = volume_extrusion > 0.0 ? vec4(position.xyz + normalize(away) * volume_extrusion, 1.0) : vec4(away, 0.0);
  }
  gl_Position = model_view_projection * p;
}
