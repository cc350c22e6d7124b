#version 330 core
// A shadow volume by the vertex shader alone, over a mesh in which each triangle has its caps and
// its sides already, drawn or not. Its vertices all know its plane, and those of a side the plane
// across the edge: so they all come to one decision, the same for both sides of the edge.
layout(location = 0) in vec4 position;  // w = 1: stays where it is; w = 0: pushed to infinity
layout(location = 1) in vec3 turned;    // in its place where the triangle is turned round
layout(location = 2) in vec4 face;      // the triangle's plane
layout(location = 3) in vec4 across;    // the plane across the edge; 0 for none, and for caps
uniform vec4 volume_light;              // model space
uniform vec4 facing_light;              // the same in the planes' units
uniform float facing_bound;             // within it a triangle is seen edge on, and counts nothing
uniform bool lit_faces_alone;           // the caster is closed: its other triangles count nothing
uniform bool mirrored;                  // by the model matrix
uniform mat4 model_view_projection;
invariant gl_Position;

// How often the triangle counts: 1 facing the light, -1 facing away.
float count(vec4 plane) {
  float side = dot(plane, facing_light);
  if (side > facing_bound) return 1.0;
  return side < -facing_bound && !lit_faces_alone ? -1.0 : 0.0;
}

void main() {
  float here = count(face);
  // Where both triangles at an edge count alike, no side stands there. All three vertices leave by
  // one plane of the view: the triangle is gone before it is set up.
  if (here == 0.0 || here == count(across)) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    return;
  }
  vec3 p = (here < 0.0) != mirrored ? turned : position.xyz;
  vec4 extruded = position.w == 0.0 ? vec4(p * volume_light.w - volume_light.xyz, 0.0) : vec4(p, 1.0);
  gl_Position = model_view_projection * extruded;
}
