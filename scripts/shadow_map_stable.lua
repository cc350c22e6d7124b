-- Cascades that do not swim. A map fitted tightly to the view changes with every step of the camera,
-- so that its texels slide along the shadows' edges and they shimmer. Here each map's extent stays
-- the same and its place moves in whole texels: a texel that two frames have in common holds the
-- same depth in both. The splits are fitted to the depth that is present, in steps too, so that they
-- move seldom.
local draw_lit = require "parts.draw_lit"
local map_array = require "parts.map_array"
local map_limit = require "parts.map_limit"
local map_pass = require "parts.map_pass"

local recipe = {
  title   = "Stable cascades",
  lecture = "003_dcbdf1292070997a: Cascaded Shadow Mapping",
  scene   = "city",
  truth   = "hard",
  params  = {
    light  = param.direction(0.7, 0.75, 0.3),
    size   = param.integer(512, 16, 4096),
    count  = param.integer(4, 1, 4),
    lambda = param.number(0.8, 0, 1),
    stable = param.toggle(true),
    -- Moves the camera to its right, metres: watch an edge far off, stable and not.
    aside  = param.number(0, -100, 100),
  },
  sweep   = { size = { 256, 512, 1024, 2048, 4096 } },
}

-- Balls around parts of a view are for a light at infinity.
function recipe.holds(r)
  return r.params.light.w == 0
end

-- The next step of √2 up or down from a distance: what is fitted in steps seldom moves.
local function step(distance, toward)
  return 2 ^ (toward(2 * math.log(distance, 2)) / 2)
end

-- The maps, and the camera that they are of.
function recipe.maps(r)
  local camera = r.scene.camera:moved(r.scene.camera:view():row(1).xyz * r.params.aside)
  local near, far = shadow.depth_present(camera)
  return shadow.cascades(camera, r.params.light, r.params.count, {
    lambda = r.params.lambda, stable = r.params.stable, size = r.params.size,
    near = step(near, math.floor), far = step(far, math.ceil),
  }), camera
end

function recipe.limit(r)
  return map_limit((recipe.maps(r)), r.params.size)
end

function recipe.setup(r)
  r.size = r.params.size
  r.depth = shader.load "flat"
  r.mapped = shader.load "shadow_map_cascades"
  r.frames = {}
end

function recipe.draw(r)
  local scene, light, size = r.scene, r.params.light, r.size
  local maps, camera = recipe.maps(r)
  local view, projection = camera:view(), camera:projection(r.width / r.height)
  local to_texture, from_eye = shadow.bias_matrix(), view:inverse()
  local matrices, ends, reach = {}, {}, 0
  local layers = map_array.layers_of(r, size, maps)

  for i, map in ipairs(maps) do
    if layers[i] >= 0 then
      pass("1. map " .. i .. " of " .. #maps, function()
        local bias = shadow.map_bias(map.projection, size)
        reach = bias.reach   -- the same for all, of one size
        map_pass.draw(r, r.frames[layers[i] + 1], size, scene.caster, r.depth, map.view, map.projection, bias)
      end)
    end
    matrices[i] = to_texture * map.projection * map.view * from_eye
    ends[i] = map.far
  end
  for i = #maps + 1, 4 do matrices[i], ends[i], layers[i] = mat4.identity(), 0, -1 end

  pass("2. the scene", function()
    if r.layers then gl.BindTexture(gl.TEXTURE_2D_ARRAY, r.layers) end
    gl.ClearColor(0.85, 0.88, 0.92, 1)
    gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
    draw_lit(scene, r.mapped, { view = view, projection = projection, light = light, shadow_maps = 0,
                                light_matrices = matrices, reach = reach, ends = ends, layers = layers, count = #maps })
  end)
end

return recipe
