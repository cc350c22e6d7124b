#version 330 core
// The triangles of which the camera sees the side that is turned from the light. Only those for
// which floats are certain of both facings: what is nearly edge on is left to the volumes.
layout(triangles_adjacency) in;  // corners 0, 2, 4
layout(triangle_strip, max_vertices = 3) out;
in vec3 corner[];
uniform vec4 volume_light;  // model space
uniform vec4 volume_eye;

// The cosine between the triangle's normal and the way to a point, or a direction.
float facing(vec3 normal, vec4 other) {
  vec3 toward = other.xyz - other.w * corner[0];
  return dot(normal, toward) / (length(normal) * length(toward));
}

void main() {
  vec3 normal = cross(corner[2] - corner[0], corner[4] - corner[0]);
  float light = facing(normal, volume_light), eye = facing(normal, volume_eye);
  if (!(light * eye < 0.0 && min(abs(light), abs(eye)) > 1e-6)) return;
  for (int i = 0; i < 6; i += 2) {
    gl_Position = gl_in[i].gl_Position;
    EmitVertex();
  }
}
