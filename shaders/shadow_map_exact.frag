#version 330 core
// A map without aliasing: the fragment's cell of the light's grid lists the triangles that can shadow
// it, and the fragment's own point is tested against each.
#include "lighting.glsl"
in vec4 shadow_coord;
uniform sampler2D ranges;      // a cell's first place in the list, and how many are there
uniform sampler2D list;        // numbers of triangles
uniform sampler2D triangles;   // three texels a triangle
uniform bool count = false;    // shows how many triangles are tested instead: 255 for white

vec4 at(sampler2D image, int index) {
  int width = textureSize(image, 0).x;
  return texelFetch(image, ivec2(index % width, index / width), 0);
}

// Twice the area of the triangle from p to an edge, the same but for its sign from either end: so that a
// point cannot slip between two triangles that share it.
float edge(vec2 p, vec2 a, vec2 b) { return (a.x - p.x) * (b.y - p.y) - (a.y - p.y) * (b.x - p.x); }

bool shadowed_by(int triangle, vec3 stp) {
  vec4 first = at(triangles, 3 * triangle), second = at(triangles, 3 * triangle + 1);
  vec2 depth = at(triangles, 3 * triangle + 2).xy, way = stp.st - first.xy;
  if (stp.p <= depth.x + dot(second.zw, way) + depth.y) return false;  // before it, or on it
  vec3 edges = vec3(edge(stp.st, first.xy, first.zw), edge(stp.st, first.zw, second.xy),
                    edge(stp.st, second.xy, first.xy));
  return all(greaterThanEqual(edges, vec3(0.0))) || all(lessThanEqual(edges, vec3(0.0)));
}

void main() {
  vec3 stp = shadow_coord.stp / shadow_coord.q;
  float seen = 1.0;
  if (shadow_coord.q > 0.0 && all(greaterThanEqual(stp.st, vec2(0.0))) && all(lessThan(stp.st, vec2(1.0)))) {
    ivec2 cell = ivec2(stp.st * vec2(textureSize(ranges, 0)));
    ivec2 range = ivec2(texelFetch(ranges, cell, 0).xy);
    for (int i = 0; i < range.y; ++i) {
      if (shadowed_by(int(at(list, range.x + i).r), stp)) {
        seen = 0.0;
        break;
      }
    }
    if (count) {
      fragment = vec4(vec3(float(range.y) / 255.0), 1.0);
      return;
    }
  }
  fragment = reflected(seen);
}
