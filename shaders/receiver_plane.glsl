// How the plane of the fragment itself climbs over a map.
//
// What is looked up beside the fragment's own place on the map may be of another face, which the map's
// offset lifts by that face's slope. Two lit planes that meet at an edge within a lookup's reach:
//  - at a rim, under a steep wall's, it is the roof: the wall's plane, continued there, is before the
//    roof, so a fragment that takes off its own plane's climb is not behind what is stored;
//  - at a wall's foot the planes meet the other way: each takes off its part of the way to the edge.
// So the map's offset and the receiver's climb, each by its own slope, leave neither in shadow.
// (J. Isidoro, Shadow Mapping: GPU-based Tips and Techniques, GDC 2006: receiver plane depth bias.)

// The change of p with s and with t. `c` is the place on the map, (s, t, p, q), and x and y are its steps
// to the next pixels: points of the plane as c is, so the slopes are exact, under a perspective too.
// Over q first: products of what is far away would be infinite.
vec2 receiver_slope(vec4 c, vec4 x, vec4 y) {
  vec3 place = c.stp / c.q, u = (x.stp - place * x.q) / c.q, v = (y.stp - place * y.q) / c.q;
  float area = u.s * v.t - u.t * v.s;
  return abs(area) < 1e-30 ? vec2(0.0)  // edge on
                           : vec2(v.t * u.p - u.t * v.p, u.s * v.p - v.s * u.p) / area;
}

// The most that it climbs within `reach`, in s and in t.
float climb(vec2 slope, vec2 reach) { return dot(abs(slope), abs(reach)); }
