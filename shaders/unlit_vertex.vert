#version 330 core
// The triangles of which the camera sees the side that is turned from the light. Only those for
// which floats are certain of both facings: what is nearly edge on is left to the volumes.
layout(location = 0) in vec3 position;
layout(location = 2) in vec4 face;  // the triangle's plane
uniform vec4 facing_light;          // model space, in the planes' units
uniform vec4 facing_eye;
uniform float facing_bound;         // the greater of the two
uniform mat4 model_view_projection;
invariant gl_Position;

void main() {
  float light = dot(face, facing_light), eye = dot(face, facing_eye);
  bool unlit = light * eye < 0.0 && min(abs(light), abs(eye)) > facing_bound;
  gl_Position = unlit ? model_view_projection * vec4(position, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
}
