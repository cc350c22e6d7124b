-- hint: The tints are shifted toward the eye: ends holds where each part begins. Part i ends at distances[i + 1].
-- hint.ca: Els colors estan desplaçats cap a l'ull: ends conté on comença cada part. La part i acaba a distances[i + 1].
-- hint.es: Los colores están desplazados hacia el ojo: ends contiene dónde empieza cada parte. La parte i acaba en distances[i + 1].
-- hint.fr: Les teintes sont décalées vers l'œil : ends contient le début de chaque partie. La partie i finit à distances[i + 1].

local draw_lit = require "parts.draw_lit"
local map_array = require "parts.map_array"
local map_pass = require "parts.map_pass"

local recipe = {
  title   = "Lab 14: cascaded shadow maps",
  lecture = "003_dcbdf1292070997a: Cascaded Shadow Mapping",
  scene   = "city",
  truth   = "hard",
  params  = {
    light    = param.direction(0.7, 0.75, 0.3),
    size     = param.integer(256, 16, 4096),     -- of each map
    lambda   = param.number(0.85, 0, 1),         -- of the splits: 0 uniform, 1 logarithmic
    darkness = param.number(0.25, 0, 1),
  },
}

local count = 4

local vertex = [[
#version 330 core
#include "shadow_coordinate.glsl"
]]

local fragment = [[
#version 330 core
#include "lighting.glsl"
uniform sampler2DArrayShadow shadow_maps;
uniform mat4 light_matrices[4];   // eye space to each map's (s, t, p, q)
uniform float ends[4];            // the distance along the view at which each part ends
const vec3 tints[4] = vec3[4](vec3(1.0, 0.35, 0.3), vec3(0.4, 0.9, 0.35), vec3(0.35, 0.5, 1.0), vec3(1.0, 0.85, 0.25));

void main() {
  float distance = -eye_position.z;
  int i = 0;
  while (i < 3 && distance > ends[i]) ++i;
  vec4 c = light_matrices[i] * vec4(eye_position, 1.0);
  float seen = texture(shadow_maps, vec4(c.st / c.q, float(i), c.p / c.q));
  if (c.p > c.q || distance > ends[3]) seen = 1.0;   // farther than the maps know
  fragment = tinted(seen, tints[i]);
}
]]

-- Where the parts of the view begin and end: count + 1 distances from near to far.
local function split_distances(near, far, lambda)
  local distances = {}
  for i = 0, count do
    local logarithmic = near * (far / near) ^ (i / count)
    local uniform = near + (far - near) * i / count
    distances[i + 1] = lambda * logarithmic + (1 - lambda) * uniform
  end
  return distances
end

function recipe.setup(r)
  r.flat = shader.load "flat"
  r.mapped = shader.compile{ vertex = vertex, fragment = fragment }
  r.maps, r.frames = map_array.make(r.params.size, count) -- the layers of a texture, a framebuffer for each
end

function recipe.draw(r)
  local scene, camera, light, size = r.scene, r.scene.camera, r.params.light, r.params.size
  local view, projection = camera:view(), camera:projection(r.width / r.height)
  local near, far = shadow.depth_present(camera)
  local distances = split_distances(near, far, r.params.lambda)
  local light_matrices, ends = {}, {}

  for i = 1, count do
    pass("1. the map of part " .. i, function()
      -- The sun's view and projection that hold the part from one distance to the next.
      local part = shadow.cascades(camera, light, 1, { near = distances[i], far = distances[i + 1], size = size })[1]
      map_pass.draw(r, r.frames[i], size, scene.caster, r.flat, part.view, part.projection,
                    shadow.map_bias(part.projection, size))
      light_matrices[i] = shadow.bias_matrix() * part.projection * part.view * view:inverse()
      ends[i] = distances[i]
    end)
  end

  pass("2. the scene", function()
    gl.BindTexture(gl.TEXTURE_2D_ARRAY, r.maps)
    gl.ClearColor(0.85, 0.88, 0.92, 1)
    gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
    draw_lit(scene, r.mapped, {
      view = view, projection = projection, light = light, ambient = r.params.darkness,
      shadow_maps = 0, light_matrices = light_matrices, ends = ends,
    })
  end)
end

return recipe
