#version 330 core
in vec3 eye_position;
uniform bool casts;
layout(location = 0) out vec4 where;   // w = 1: there is something
layout(location = 1) out vec4 facing;  // the triangle's unit normal, toward the eye; w = 1: it casts shadows

void main() {
  where = vec4(eye_position, 1.0);
  facing = vec4(normalize(cross(dFdx(eye_position), dFdy(eye_position))), casts ? 1.0 : 0.0);
}
