-- Right in another way: textureProj divides, so the offset is multiplied by q beforehand.
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
in vec4 shadow_coord;
uniform sampler2DShadow shadow_map;
uniform float texel;        // a texel's side in texture coordinates
uniform int reach;

void main() {
  float seen = 0.0;
  for (int y = -reach; y <= reach; ++y)
    for (int x = -reach; x <= reach; ++x)
      seen += textureProj(shadow_map, shadow_coord + vec4(vec2(x, y) * texel * shadow_coord.q, 0.0, 0.0));
  float side = float(2 * reach + 1);
  seen /= side * side;
  fragment = reflected(seen);
}
]]

function recipe.setup(r)
  r.flat = shader.load "flat"
  r.mapped = shader.compile{ vertex = vertex, fragment = fragment }
  r.fbo, r.map = map_pass.make(r.params.size)
  gl.BindTexture(gl.TEXTURE_2D, r.map)
  gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_COMPARE_MODE, gl.COMPARE_REF_TO_TEXTURE)
  gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_COMPARE_FUNC, gl.LEQUAL)
  gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR)
  gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.LINEAR)
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
