-- Lab 10. The texture is there, and the scene is drawn, lit everywhere. Draw the map, copy it, look it up:
-- fill in what is marked TO DO. README.md has the theory.
local draw_lit = require "parts.draw_lit"

local recipe = {
  title   = "Lab 10: a shadow map, copied from the depth buffer",
  lecture = "000_178f3ee06912f876: Shadow mapping",
  scene   = "table",
  truth   = "hard",
  params  = { light = param.point(2, 4, 1), darkness = param.number(0.25, 0, 1) },
}

local vertex = [[
#version 330 core
// shadow_coord = light_matrix * the vertex in eye space: (s, t, p, q).
#include "shadow_coordinate.glsl"
]]

local fragment = [[
#version 330 core
#include "lighting.glsl"
in vec4 shadow_coord;
uniform sampler2D shadow_map;

void main() {
  // TO DO (4): where in the map this fragment is, its depth as seen from the light, the depth that the
  // map holds there. Lit where it is no farther.
  float seen = 1.0;
  fragment = reflected(seen);
}
]]

function recipe.setup(r)
  r.flat = shader.load "flat"
  r.mapped = shader.compile{ vertex = vertex, fragment = fragment }
  r.size = math.min(r.width, r.height)       -- the map is copied from the window, and no larger

  r.map = gl.GenTextures(1)
  gl.BindTexture(gl.TEXTURE_2D, r.map)
  gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_BORDER)
  gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_BORDER)
  gl.TexParameterfv(gl.TEXTURE_2D, gl.TEXTURE_BORDER_COLOR, { 1, 1, 1, 1 })
  gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST)
  gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST)
  gl.TexImage2D(gl.TEXTURE_2D, 0, gl.DEPTH_COMPONENT24, r.size, r.size, 0, gl.DEPTH_COMPONENT, gl.FLOAT, nil)
end

function recipe.draw(r)
  local scene, camera, light, size = r.scene, r.scene.camera, r.params.light, r.size
  local view, projection = camera:view(), camera:projection(r.width / r.height)
  -- gluLookAt and gluPerspective of a camera at the light, around the casters.
  local light_view, light_projection = shadow.light_view(light, scene, { fit = "scene" })
  local bias = shadow.map_bias(light_projection, size)
  gl.Enable(gl.DEPTH_TEST)

  pass("1. the shadow map", function()
    -- TO DO (1): a viewport of the map's size; clear; draw the casters with r.flat as the light sees them,
    -- with a polygon offset of bias.factor, bias.units; copy the depths into r.map.
  end)

  pass("2. the scene, compared with the map", function()
    -- TO DO (2): the window's viewport again.
    gl.ClearColor(0.85, 0.88, 0.92, 1)
    gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
    -- TO DO (3): from eye space to the world, to the light's eye, to its clip space, to [0, 1]³.
    local light_matrix = mat4.identity()
    draw_lit(scene, r.mapped, { view = view, projection = projection, light = light, shadow_map = 0,
                                light_matrix = light_matrix, ambient = r.params.darkness })
  end)
end

return recipe
