-- A hard shadow with no aliasing at all from the light's view, said to be too slow to be taught: an
-- ordinary map keeps one depth for a texel and lets every point of it share that. Here a cell of the
-- light's grid keeps the triangles that reach into it, and every fragment is tested against those in
-- its own place: no texel, no bias, no contact gap (the dual of G. Johnson et al., The Irregular
-- Z-Buffer, 2005, and T. Aila, S. Laine, Alias-Free Shadow Maps, 2004, which keep the view's samples
-- in the light's grid and run over the casters). While light, casters and camera are still the grid is
-- kept; its size is a matter of speed alone, not of the picture.
--
-- What is left is a float's rounding: a point nearer to a silhouette than the map's coordinates and
-- depths can tell, some millionths of the map, may fall on either side of it. Seen from inside of a
-- caster, along the crease of a lit and an unlit face, that is a lit pixel in the dark, about one in
-- 300,000; a smaller tolerance in depth loses more, to acne. Where hundreds of large triangles lie over
-- each other in every cell, as in the scene shells, sorting them takes seconds: 48 cells a side do there.
local draw_lit = require "parts.draw_lit"
local map_limit = require "parts.map_limit"
local triangle_grid = require "parts.triangle_grid"

local recipe = {
  title   = "A shadow map without aliasing",
  lecture = "003_dcbdf1292070997a: Problemas del Shadow Mapping, aliasing",
  scene   = "table",
  truth   = "hard",
  params  = {
    light = param.point(2, 4, 1),
    cells = param.integer(192, 1, 512),      -- of a side of the grid
    count = param.toggle(false),             -- shows how many triangles each fragment is tested against
  },
  sweep   = { cells = { 16, 32, 64, 128, 256 } },
}

function recipe.holds(r)
  return pcall(shadow.light_view, r.params.light, r.scene)
end

-- The rounding of what is compared, in the light's square and in depth (parts.triangle_grid): 1e-5 of the
-- map's side, and 2e-6 of its depth, which is 34 steps of 24 bits.
function recipe.limit(r)
  local _, projection = shadow.light_view(r.params.light, r.scene)
  local limit = map_limit({ projection }, 1e5)
  limit.light_units = 34
  return limit
end

function recipe.setup(r)
  r.mapped = shader.load "shadow_map_exact"
  r.ranges, r.list, r.triangles = gl.GenTextures(3)
end

function recipe.draw(r)
  local scene, camera, light, cells = r.scene, r.scene.camera, r.params.light, r.params.cells
  local light_view, light_projection, near = shadow.light_view(light, scene)
  local to_texture = shadow.bias_matrix() * light_projection * light_view

  pass("1. the casters' triangles, into the light's grid", function()
    local wanted = tostring(to_texture) .. cells
    if r.grid_of ~= wanted then
      local grid = triangle_grid.build(scene.casters, to_texture, light.w > 0 and near / 2 or 0.5, cells)
      triangle_grid.upload(gl.TEXTURE0, r.ranges, gl.RG32F, gl.RG, grid.ranges, 2, cells)
      triangle_grid.upload(gl.TEXTURE1, r.list, gl.R32F, gl.RED, grid.list, 1, 1024)
      triangle_grid.upload(gl.TEXTURE2, r.triangles, gl.RGBA32F, gl.RGBA, grid.triangles, 4, 1020)
      r.grid_of = wanted
    end
  end)

  pass("2. the scene, each fragment against its cell's triangles", function()
    local view, projection = camera:view(), camera:projection(r.width / r.height)
    for i, texture in ipairs { r.ranges, r.list, r.triangles } do
      gl.ActiveTexture(gl.TEXTURE0 + i - 1)
      gl.BindTexture(gl.TEXTURE_2D, texture)
    end
    gl.ClearColor(0.85, 0.88, 0.92, 1)
    gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
    gl.Enable(gl.DEPTH_TEST)
    draw_lit(scene, r.mapped, {
      view = view, projection = projection, light = light, ranges = 0, list = 1, triangles = 2,
      light_matrix = to_texture * view:inverse(), count = r.params.count,
    })
  end)
end

return recipe
