#version 330 core
// A shadow volume by the geometry shader: each triangle knows the three across its edges, so it can
// tell which of its edges are silhouettes, and throws a side on those and caps at both ends.
layout(triangles_adjacency) in;  // corners 0, 2, 4; across 0-2: 1, across 2-4: 3, across 4-0: 5
layout(triangle_strip, max_vertices = 24) out;
in vec3 corner[];
in vec4 pushed[];
uniform vec4 volume_light;      // model space
uniform bool lit_faces_alone;   // the caster is closed: its other triangles count nothing
uniform bool mirrored;          // by the model matrix

bool before(vec3 a, vec3 b) {
  return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
}

// How often triangle (a, b, c) counts: 1 facing the light, -1 facing away, 0 edge on. Its corners are
// sorted first, so that this is the same arithmetic, to the bit, whichever neighbour asks.
float count(vec3 a, vec3 b, vec3 c) {
  float turn = 1.0;
  vec3 t;
  if (before(b, a)) { t = a; a = b; b = t; turn = -turn; }
  if (before(c, b)) { t = b; b = c; c = t; turn = -turn; }
  if (before(b, a)) { t = a; a = b; b = t; turn = -turn; }
  vec3 normal = cross(b - a, c - a), toward = volume_light.xyz - volume_light.w * a;
  float side = dot(normal, toward);
  if (abs(side) <= 1e-6 * length(normal) * length(toward)) return 0.0;
  side *= turn;
  return side > 0.0 ? 1.0 : lit_faces_alone ? 0.0 : -1.0;
}

void kept(int i) { gl_Position = gl_in[i].gl_Position; EmitVertex(); }
void at_infinity(int i) { gl_Position = pushed[i]; EmitVertex(); }

// The front cap runs along a to b, so the side runs from b to a. Two triangles, each from the corner
// from which it would start in a list: a strip of four would start one of them elsewhere, and where it
// is clipped then round otherwise than the side next to it, pixel by pixel.
void side(int a, int b) {
  kept(b);
  kept(a);
  at_infinity(a);
  EndPrimitive();
  kept(b);
  at_infinity(a);
  at_infinity(b);
  EndPrimitive();
}

void main() {
  float here = count(corner[0], corner[2], corner[4]);
  if (here == 0.0) return;
  bool turned = (here < 0.0) != mirrored;
  int a = turned ? 2 : 0, b = turned ? 0 : 2;

  kept(a);
  kept(b);
  kept(4);
  EndPrimitive();
  at_infinity(turned ? 4 : 0);
  at_infinity(turned ? 0 : 4);
  at_infinity(2);
  EndPrimitive();

  for (int i = 0; i < 6; i += 2) {
    int j = (i + 2) % 6;
    if (count(corner[j], corner[i], corner[i + 1]) == here) continue;
    if (turned) side(j, i); else side(i, j);
  }
}
