#version 330 core
// The visibility of a light with a size, from the hard shadow of its centre.
//   even     the mean over a disc of some pixels
//   contact  the mean over the light. Seen from P, a point of the light is hidden where the ray to it
//            meets the caster; from the light's centre the same point of the caster hides another P'.
//            So P' is looked up in the hard shadow, for each point of the light: far from where the
//            caster touches the receiver they lie far apart, and the shadow is wide.
// Either way points count only where they are on the surface that P is on, and the weights are divided
// by their sum: what is lit or dark all around stays exactly so.
uniform sampler2D surface;    // eye space
uniform sampler2D normals;
uniform sampler2D hard;       // 1 where the centre of the light is seen
uniform sampler2D nearest;    // the nearest outline, and how far its casting edge is from the light
uniform vec4 light;           // its centre, eye space
uniform float radius;         // metres, of a sphere
uniform mat4 projection;
uniform bool by_contact;
uniform float width;          // pixels, of the even blur
out float visibility;

const int AVERAGED = 96, EDGES = 16;
const float GOLDEN = 2.399963229728653;  // the angle that fills a disc evenly, radians

vec2 on_disc(int i, int count) {
  float r = sqrt((float(i) + 0.5) / float(count)), a = float(i) * GOLDEN;
  return r * vec2(cos(a), sin(a));
}

vec3 on_sphere(int i, int count) {
  float h = 1.0 - (2.0 * float(i) + 1.0) / float(count), a = float(i) * GOLDEN;
  return vec3(sqrt(1.0 - h * h) * vec2(cos(a), sin(a)), h);
}

bool inside(ivec2 pixel) {
  return all(greaterThanEqual(pixel, ivec2(0))) && all(lessThan(pixel, textureSize(surface, 0)));
}

// Whether what is seen at `pixel` belongs to the surface through p with normal n.
bool same_surface(ivec2 pixel, vec3 p, vec3 n, float footprint) {
  if (!inside(pixel)) return false;
  vec4 q = texelFetch(surface, pixel, 0);
  return q.w > 0.0 && abs(dot(n, q.xyz - p)) < 0.1 * length(q.xyz - p) + footprint;
}

// How far from the light the edge is whose shadow ends near p: the mean over the nearest ones of the
// points around, so that it changes smoothly between two edges; or -1 where none is so near that its
// penumbra could reach p.
float casting_distance(ivec2 pixel, vec3 p, vec3 n, float footprint) {
  vec4 edge = texelFetch(nearest, pixel, 0);
  float half_width = radius * (length(p - light.xyz) - edge.w) / edge.w;
  if (edge.w == 0.0 || length(edge.xyz - p) > 1.5 * half_width + 2.0 * footprint) return -1.0;
  float sum = edge.w, weights = 1.0;
  for (int i = 0; i < EDGES; ++i) {
    ivec2 other = pixel + ivec2(round(half_width / footprint * on_disc(i, EDGES)));
    if (!same_surface(other, p, n, footprint)) continue;
    float found = texelFetch(nearest, other, 0).w;
    if (found == 0.0) continue;
    sum += found;
    weights += 1.0;
  }
  return min(sum / weights, length(p - light.xyz));
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 seen = texelFetch(surface, pixel, 0);
  visibility = texelFetch(hard, pixel, 0).r;
  if (seen.w == 0.0) return;
  vec4 facing = texelFetch(normals, pixel, 0);
  vec3 p = seen.xyz, n = facing.xyz;
  vec2 size = vec2(textureSize(surface, 0));
  float footprint = -2.0 * p.z / (projection[1][1] * size.y);  // of a pixel, metres

  float sum = 0.0, weights = 0.0;
  if (!by_contact) {
    for (int i = 0; i < AVERAGED; ++i) {
      ivec2 other = pixel + ivec2(round(width * on_disc(i, AVERAGED)));
      if (!same_surface(other, p, n, footprint)) continue;
      sum += texelFetch(hard, other, 0).r;
      weights += 1.0;
    }
  } else {
    float edge = casting_distance(pixel, p, n, footprint), height = dot(n, light.xyz - p);
    bool casts = facing.w > 0.0;  // what only receives hides no light, not even from its other side
    // No edge is near, and the surface itself hides all of the light or none.
    if (edge < 0.0 && (!casts || abs(height) >= radius)) return;
    float fraction = 1.0 - edge / length(p - light.xyz);
    for (int i = 0; i < AVERAGED; ++i) {
      vec3 to_light = light.xyz + radius * on_sphere(i, AVERAGED) - p;
      float seen_here = edge < 0.0 ? visibility : 1.0;
      if (casts && dot(n, to_light) <= 0.0) {
        seen_here = 0.0;  // by the surface itself
      } else if (casts && height <= 0.0) {
        seen_here = 1.0;  // the light's centre is below the horizon: its shadow says nothing
      } else if (edge >= 0.0) {
        // The caster's point on the ray from p to this point of the light, and then the receiver's p'.
        vec3 ray = p + fraction * to_light - light.xyz;
        float along = dot(n, p - light.xyz) / dot(n, ray);
        vec4 clip = projection * vec4(light.xyz + along * ray, 1.0);
        if (!(along > 0.0 && clip.w > 0.0)) continue;
        ivec2 other = ivec2(floor((clip.xy / clip.w * 0.5 + 0.5) * size));
        if (!same_surface(other, p, n, footprint)) continue;
        seen_here = texelFetch(hard, other, 0).r;
      }
      sum += seen_here;
      weights += 1.0;
    }
  }
  if (weights > 0.0) visibility = sum / weights;
}
