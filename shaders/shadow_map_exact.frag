#version 330 core
#extension GL_ARB_gpu_shader_fp64 : require
// A map without aliasing: the fragment's cell of the light's grid lists the triangles that can shadow
// it, and the fragment's own point is tested against the planes around each one's shadow.
//
// Nearly every answer is a float's. Where the float leaves a doubt the point is sought again, on the
// fragment's own triangle and in double: then it is on a plane only where it is, to some 1e-13 of its
// distance from the light, because it shares the triangle, or its plane, or an edge. There, what the truth
// says is said: a sheet shadows its points where the eye and the light are on different sides of it.
#include "lighting.glsl"
uniform sampler2D ranges;      // a cell's first place in the list, and how many are there
uniform sampler2D list;        // numbers of triangles, 1024 a row
uniform sampler2D triangles;   // shadow.triangle_grid's records, 16 texels each, 64 records a row
uniform int first_own;         // the number of the object's first triangle
uniform mat4 eye_to_grid;      // eye space to the grid's, world axes around its origin
uniform mat4 map_high, map_low;  // from there to the map's (s, t, p, q)
uniform vec3 ray_high[4], ray_low[4];  // the eye; the way to the pixel at 0, 0; to the next right, and up
uniform float cell;            // its side, over the distance from a point light: metres a metre, else metres
uniform float depth_step;      // over the distance squared: what depth may not tell apart
uniform bool count = false;    // shows how many triangles are tested instead: 255 for white

const float rough = 2e-6;             // of a plane's value, over what it is the sum of: 16 roundings
const float overhang = 1.0 / 128.0;   // pixels: a rasteriser moves corners by 1/512
const double margin = 1e-8LF;         // a triangle's inner points, in shares of it
const double fine = 1e-13LF;          // as `rough`: 2^-48 of what two floats keep, and roundings

int own;            // the fragment's triangle
dvec3 eye, point;   // what is asked about
float tie;          // what is nearer to the point than this may hide it, or it that

vec4 texel(int triangle, int i) {
  return texelFetch(triangles, ivec2((triangle & 63) * 16 + i, triangle >> 6), 0);
}
int listed(int i) { return int(texelFetch(list, ivec2(i & 1023, i >> 10), 0).r); }

dvec3 corner(int triangle, int i) {
  return dvec3(texel(triangle, 8 + 2 * i).xyz) + dvec3(texel(triangle, 9 + 2 * i).xyz);
}
dvec4 plane(int triangle, int i) { return dvec4(texel(triangle, i)) + dvec4(texel(triangle, 4 + i)); }
double value(dvec4 plane, dvec3 p) { return dot(plane.xyz, p) + plane.w; }
dvec3 ray(int i) { return dvec3(ray_high[i]) + dvec3(ray_low[i]); }

// Of the edge from a to b the point nearest to the ray, and how far that is, squared.
dvec3 on_edge(dvec3 a, dvec3 b, dvec3 way, out double distance) {
  dvec3 from = a - eye, along = b - a;
  from -= way * (dot(from, way) / dot(way, way));
  dvec3 across = along - way * (dot(along, way) / dot(way, way));
  double square = dot(across, across);
  double t = square > 0.0LF ? clamp(-dot(from, across) / square, 0.0LF, 1.0LF) : 0.0LF;
  from += across * t;
  distance = dot(from, from);
  return a + along * t;
}

// What the pixel's ray meets of its triangle. A rasteriser gives a triangle pixels whose centres lie
// beyond it: those are the nearest of its edges' points. A point of an edge is of two triangles, and
// stands for those of its own: so it is moved in, by so little that no picture shows it.
dvec3 seen_point(dvec3 way) {
  dvec3 a = corner(own, 0), b = corner(own, 1), c = corner(own, 2);
  dvec3 ab = b - a, ac = c - a, from = eye - a;
  dvec3 p = cross(way, ac), q = cross(from, ab);
  double determinant = dot(ab, p);
  double beta = dot(from, p), gamma = dot(way, q);
  if (determinant < 0.0LF) {
    determinant = -determinant;
    beta = -beta;
    gamma = -gamma;
  }
  double least = min(min(beta, gamma), determinant - beta - gamma);
  if (determinant > 0.0LF && least > margin * determinant)
    return a + (ab * (beta / determinant) + ac * (gamma / determinant));
  double distances[3];
  dvec3 points[3] = dvec3[3](on_edge(a, b, way, distances[0]), on_edge(b, c, way, distances[1]),
                             on_edge(c, a, way, distances[2]));
  int nearest = distances[1] < distances[0] ? 1 : 0;
  if (distances[2] < distances[nearest]) nearest = 2;
  return mix(points[nearest], (a + b + c) / 3.0LF, margin * 3.0LF);
}

double least_of(int triangle, dvec3 p) {
  return min(value(plane(triangle, 1), p), min(value(plane(triangle, 2), p), value(plane(triangle, 3), p)));
}

bool shadowed_by(int triangle) {
  dvec4 sheet = plane(triangle, 0);
  double slack = fine * (abs(point.x) + abs(point.y) + abs(point.z) + abs(sheet.w));
  double before = value(sheet, point), of_eye = value(sheet, eye);
  if (abs(before) <= slack)  // On it: inside of it, not only at an edge, the side that is seen decides.
    return least_of(triangle, point) > slack && of_eye < 0.0LF;
  if (before * of_eye < 0.0LF && abs(before) < tie) {
    // As near as depth can tell, the sheet may hide the point from the eye: then its own side is seen.
    if (least_of(triangle, mix(point, eye, before / (before - of_eye))) > slack) return of_eye < 0.0LF;
  }
  return before < 0.0LF && least_of(triangle, point) >= 0.0LF;
}

bool surely_dark() {
  eye = ray(0);
  point = seen_point(ray(1) + ray(2) * double(gl_FragCoord.x) + ray(3) * double(gl_FragCoord.y));
  if (casts && value(plane(own, 0), eye) < 0.0LF) return true;
  dvec4 stpq = (dmat4(map_high) + dmat4(map_low)) * dvec4(point, 1.0LF);
  dvec2 place = stpq.xy / stpq.w;
  if (stpq.w <= 0.0LF || any(lessThan(place, dvec2(0.0LF))) || any(greaterThanEqual(place, dvec2(1.0LF))))
    return false;
  ivec2 range = ivec2(texelFetch(ranges, ivec2(place * dvec2(textureSize(ranges, 0))), 0).xy);
  for (int i = 0; i < range.y; ++i) {
    int triangle = listed(range.x + i);
    if (triangle != own && shadowed_by(triangle)) return true;
  }
  return false;
}

const int LIT = 0, DOUBT = 1, DARK = 2;

float size_of(vec3 p) { return abs(p.x) + abs(p.y) + abs(p.z); }

// What floats say of the point p, which may be off by `off`, seen from e.
int rough_answer(int triangle, vec3 p, float off, vec3 e) {
  vec4 sheet = texel(triangle, 0);
  float size = size_of(p);
  float slack = off + rough * (size + abs(sheet.w));
  float before = dot(sheet.xyz, p) + sheet.w, of_eye = dot(sheet.xyz, e) + sheet.w;
  // Whether the sheet may hide the point.
  bool tied = abs(before) < tie + 4.0 * off + slack &&
              before * of_eye < slack * (abs(before) + abs(of_eye));
  if (before > slack && !tied) return LIT;
  int answer = before < -slack && !tied ? DARK : DOUBT;
  for (int i = 1; i < 4; ++i) {
    vec4 edge = texel(triangle, i);
    float inside = dot(edge.xyz, p) + edge.w;
    slack = off + rough * (size + abs(edge.w));
    if (inside < -slack && !tied) return LIT;
    if (inside < slack) answer = DOUBT;
  }
  return answer;
}

void main() {
  own = first_own + gl_PrimitiveID;
  vec3 p = (eye_to_grid * vec4(eye_position, 1.0)).xyz, e = eye_to_grid[3].xyz;
  // By places from the eye: from a light far away floats tell neither their steps nor their distance.
  float moved = overhang * (length(dFdx(eye_position)) + length(dFdy(eye_position)));
  float off = moved + rough * size_of(e);
  tie = 4.0 * moved + depth_step * dot(eye_position, eye_position);
  int answer = LIT, tested = 0;
  if (casts) {
    vec4 sheet = texel(own, 0);
    float of_eye = dot(sheet.xyz, e) + sheet.w, slack = rough * (size_of(e) + abs(sheet.w));
    answer = of_eye < -slack ? DARK : of_eye < slack ? DOUBT : LIT;
  }
  vec4 stpq = map_high * vec4(p, 1.0);
  vec2 cells = vec2(textureSize(ranges, 0)), place = stpq.st / stpq.q * cells;
  // As far as floats tell; from a light far away they may name another cell.
  float unsure = rough * (size_of(p) + size_of(e)) / (stpq.q * cell);
  bool on_map = stpq.q > 0.0 && all(greaterThan(place, vec2(-unsure))) && all(lessThan(place, cells + unsure));
  if (answer != DARK && on_map) {
    ivec2 range = ivec2(texelFetch(ranges, ivec2(clamp(place, vec2(0.0), cells - 1.0)), 0).xy);
    tested = range.y;
    vec2 in_cell = fract(place);
    if (any(lessThan(min(in_cell, 1.0 - in_cell), vec2(unsure)))) answer = DOUBT;
    for (int i = 0; i < range.y && answer != DARK; ++i) {
      int triangle = listed(range.x + i);
      if (triangle != own) answer = max(answer, rough_answer(triangle, p, off, e));
    }
  }
  bool dark = answer == DARK || (answer == DOUBT && surely_dark());
  fragment = count ? vec4(vec3(float(tested) / 255.0), 1.0) : reflected(dark ? 0.0 : 1.0);
}
