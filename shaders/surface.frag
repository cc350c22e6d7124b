#version 330 core
in vec3 eye_position;
layout(location = 0) out vec4 where;   // w = 1: there is something
layout(location = 1) out vec4 facing;  // of the triangle, toward the eye; unit length

void main() {
  where = vec4(eye_position, 1.0);
  facing = vec4(normalize(cross(dFdx(eye_position), dFdy(eye_position))), 0.0);
}
