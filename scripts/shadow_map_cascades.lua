-- Several maps instead of one, so that what is near has texels enough. The lecture's three ways:
--
--   view     the view is split along its depth, a map a part (parallel-split shadow mapping)
--   camera   maps centred on the camera, each wider than the last
--   groups   a map for each group of casters: near ones, the camera's block, the rest; a fragment is
--            in shadow where any of them says so
--
-- The picture is tinted by the map that each fragment was shaded by.
local draw_lit = require "parts.draw_lit"
local map_array = require "parts.map_array"
local map_limit = require "parts.map_limit"
local map_pass = require "parts.map_pass"

local recipe = {
  title   = "Cascaded shadow maps",
  lecture = "003_dcbdf1292070997a: Cascaded Shadow Mapping",
  scene   = "city",
  truth   = "hard",
  params  = {
    light   = param.direction(0.7, 0.75, 0.3),
    size    = param.integer(512, 16, 4096),   -- of each map
    count   = param.integer(4, 1, 4),
    lambda  = param.number(0.8, 0, 1),        -- 0 the uniform split, 1 the logarithmic one
    by      = param.choice("view", "camera", "groups"),
    present = param.toggle(true),             -- split the depth that is present, not all of it
    tint    = param.toggle(true),
  },
  sweep   = { size = { 256, 512, 1024, 2048, 4096 }, count = { 1, 2, 3, 4 } },
}

function recipe.holds(r)
  return pcall(recipe.maps, r)
end

-- Casters in groups by their distance from the camera, in front of it or not.
local function groups_of(scene, distances)
  local groups = {}
  for i = 1, #distances - 1 do groups[i] = {} end
  for _, caster in ipairs(scene.casters) do
    local center = caster.model:transform_point((caster.mesh.low + caster.mesh.high) / 2)
    local distance, i = (center - scene.camera.eye):length(), 1
    while i < #groups and distance > distances[i + 1] do i = i + 1 end
    table.insert(groups[i], caster)
  end
  return groups
end

-- What each map is: its view and projection, its casters, how far along the view it serves.
function recipe.maps(r)
  local scene, camera, params = r.scene, r.scene.camera, r.params
  local near, far = camera.near, camera.far
  if params.present then near, far = shadow.depth_present(camera) end
  if params.by ~= "groups" then
    return shadow.cascades(camera, params.light, params.count, {
      lambda = params.lambda, size = params.size, near = near, far = far,
      around = params.by == "camera" and "camera" or "parts",
    })
  end
  local maps = {}
  local distances = shadow.split_distances(near, far, params.count, params.lambda)
  for i, group in ipairs(groups_of(scene, distances)) do
    local view, projection = shadow.light_view(params.light, scene, { casters = group })
    maps[i] = { view = view, projection = projection, casters = group, far = far }
  end
  return maps
end

function recipe.limit(r)
  return map_limit(recipe.maps(r), r.params.size)
end

-- A list of objects drawn as one.
local function all_of(objects)
  return { draw = function(_, shader, uniforms)
    for _, object in ipairs(objects) do object:draw(shader, uniforms) end
  end }
end

function recipe.setup(r)
  r.size = r.params.size
  r.depth = shader.load "flat"
  r.mapped = shader.load "shadow_map_cascades"
  r.frames = {}
end

function recipe.draw(r)
  local scene, camera, light, size = r.scene, r.scene.camera, r.params.light, r.size
  local maps = recipe.maps(r)
  local view, projection = camera:view(), camera:projection(r.width / r.height)
  local to_texture, from_eye = shadow.bias_matrix(), view:inverse()
  local matrices, ends, reach = {}, {}, 0
  local layers = map_array.layers_of(r, size, maps)

  for i, map in ipairs(maps) do
    if layers[i] >= 0 then
      pass("1. map " .. i .. " of " .. #maps, function()
        local bias = shadow.map_bias(map.projection, size)
        reach = bias.reach   -- the same for all, of one size
        local casters = map.casters and all_of(map.casters) or scene.caster
        map_pass.draw(r, r.frames[layers[i] + 1], size, casters, r.depth, map.view, map.projection, bias)
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
    draw_lit(scene, r.mapped, {
      view = view, projection = projection, light = light, shadow_maps = 0, tint = r.params.tint,
      light_matrices = matrices, reach = reach, ends = ends, layers = layers, count = #maps,
      choice = ({ view = 0, camera = 1, groups = 2 })[r.params.by],
    })
  end)
end

return recipe
