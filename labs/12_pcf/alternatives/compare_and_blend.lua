-- Right in another way: depths are read as they are; the shader compares with four texels and blends.
local draw_lit = require "parts.draw_lit"
local map_pass = require "parts.map_pass"

local recipe = {
  title   = "Lab 12: percentage-closer filtering",
  lecture = "003_dcbdf1292070997a: Percentage-Closer Filtering (PCF)",
  scene   = "table",
  params  = {
    light    = param.point(2, 4, 1),
    reach    = param.integer(2, 0, 8),          -- the filter takes this many texels to each side
    size     = param.integer(64, 16, 4096),     -- of the map
    darkness = param.number(0.25, 0, 1),
  },
}

local vertex = [[
#version 330 core
#include "shadow_coordinate.glsl"
]]

local fragment = [[
#version 330 core
#include "lighting.glsl"
uniform float texel;        // a texel's side in texture coordinates
in vec4 shadow_coord;
uniform sampler2D shadow_map;

float lit(vec2 corner, vec2 offset, float depth) {
  return depth <= texture(shadow_map, (corner + offset + 0.5) * texel).r ? 1.0 : 0.0;
}

float blended(vec3 stp) {
  vec2 place = stp.st / texel - 0.5, corner = floor(place), f = place - corner;
  return mix(mix(lit(corner, vec2(0, 0), stp.p), lit(corner, vec2(1, 0), stp.p), f.x),
             mix(lit(corner, vec2(0, 1), stp.p), lit(corner, vec2(1, 1), stp.p), f.x), f.y);
}
uniform int reach;

void main() {
  vec3 stp = shadow_coord.stp / shadow_coord.q;
  float seen = 0.0;
  for (int y = -reach; y <= reach; ++y)
    for (int x = -reach; x <= reach; ++x)
      seen += blended(vec3(stp.st + vec2(x, y) * texel, stp.p));
  float side = float(2 * reach + 1);
  seen /= side * side;
  fragment = reflected(seen);
}
]]

function recipe.setup(r)
  r.flat = shader.load "flat"
  r.mapped = shader.compile{ vertex = vertex, fragment = fragment }
  r.fbo, r.map = map_pass.make(r.params.size)
end

function recipe.draw(r)
  local scene, camera, light, size, reach = r.scene, r.scene.camera, r.params.light, r.params.size, r.params.reach
  local view, projection = camera:view(), camera:projection(r.width / r.height)
  local light_view, light_projection = shadow.light_view(light, scene, { fit = "scene" })

  -- A filter compares with texels farther off, and on a slanted surface their depths differ by more.
  pass("1. the map", function()
    map_pass.draw(r, r.fbo, size, scene.caster, r.flat, light_view, light_projection,
                  shadow.map_bias(light_projection, size, 2 * reach + 2))
  end)

  pass("2. the scene, filtered", function()
    gl.ClearColor(0.85, 0.88, 0.92, 1)
    gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
    gl.BindTexture(gl.TEXTURE_2D, r.map)
    draw_lit(scene, r.mapped, {
      view = view, projection = projection, light = light, ambient = r.params.darkness,
      light_matrix = shadow.bias_matrix() * light_projection * light_view * view:inverse(),
      shadow_map = 0, texel = 1 / size, reach = reach,
    })
  end)
end

return recipe
