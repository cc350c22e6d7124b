-- Percentage-closer filtering: not depths are averaged, but the results of comparing them. The hardware
-- does it for 2 × 2 texels when the comparing map's filter is LINEAR; one's own does it with any
-- number of taps, over any width, in any pattern, with any weights. The edge is soft, and equally
-- so everywhere: its width is the filter's in the map, not the light's (shadow_map_pcss does that).
local draw_lit = require "parts.draw_lit"
local map_limit = require "parts.map_limit"
local map_pass = require "parts.map_pass"

local recipe = {
  title   = "Percentage-closer filtering",
  lecture = "003_dcbdf1292070997a: Percentage-Closer Filtering (PCF)",
  scene   = "table",
  truth   = "hard",
  params  = {
    light    = param.point(2, 4, 1),
    size     = param.integer(512, 16, 4096),
    number   = param.integer(4, 1, 8),            -- taps are number × number
    width    = param.number(4, 0, 32),            -- of the filtered square, texels
    pattern  = param.choice("grid", "poisson", "rotated"),
    weights  = param.choice("equal", "tent"),     -- tent: less the farther from the middle
    hardware = param.toggle(true),                -- 2 × 2 at each tap
  },
  sweep   = { number = { 1, 2, 4, 8 } },
}

function recipe.holds(r)
  return pcall(shadow.light_view, r.params.light, r.scene)
end

-- Places in [-1/2, 1/2]², in rows and columns.
local function grid(n)
  local places = {}
  for j = 0, n - 1 do
    for i = 0, n - 1 do places[#places + 1] = vec2((i + 0.5) / n - 0.5, (j + 0.5) / n - 0.5) end
  end
  return places
end

-- n² places in the disk of radius 1/2, each as far as can be from those before it: of many random
-- ones the best (Mitchell's best candidate, 1991).
local function poisson(n)
  local places, random = {}, 1
  local function unit()      -- the minimal standard generator (Park and Miller, 1988)
    random = random * 16807 % 2147483647
    return random / 2147483647
  end
  while #places < n * n do
    local best, farthest = nil, -1
    for _ = 1, 16 * (#places + 1) do
      local candidate = vec2(unit() - 0.5, unit() - 0.5)
      local nearest = math.huge
      for _, place in ipairs(places) do nearest = math.min(nearest, (place - candidate):length()) end
      if candidate:length() <= 0.5 and nearest > farthest then best, farthest = candidate, nearest end
    end
    if best then places[#places + 1] = best end
  end
  return places
end

-- Places in texels with weights that add up to 1.
local function filter(params)
  local places = params.pattern == "grid" and grid(params.number) or poisson(params.number)
  local sum, taps = 0, {}
  for i, place in ipairs(places) do
    local weight = 1
    if params.weights == "tent" then
      weight = math.max(0, 1 - 2 * math.abs(place.x)) * math.max(0, 1 - 2 * math.abs(place.y)) + 1e-6
    end
    sum = sum + weight
    taps[i] = vec3(place.x * params.width, place.y * params.width, weight)
  end
  for i, tap in ipairs(taps) do taps[i] = vec3(tap.x, tap.y, tap.z / sum) end
  return taps
end

function recipe.limit(r)
  local _, projection = shadow.light_view(r.params.light, r.scene)
  return map_limit({ { projection = projection } }, r.params.size, r.params.width + 2)
end

function recipe.setup(r)
  r.size, r.texels = r.params.size, r.params.hardware and gl.LINEAR or gl.NEAREST
  r.depth = shader.load "flat"
  r.mapped = shader.load "shadow_map_pcf"
end

function recipe.draw(r)
  local scene, camera, light, size = r.scene, r.scene.camera, r.params.light, r.size
  local light_view, light_projection = shadow.light_view(light, scene)
  local taps = filter(r.params)
  -- A disk that turns reaches as far as its circle in every direction.
  local reads = (#taps > 1 and r.params.width or 0) + (r.params.hardware and 2 or 1)

  local bias = shadow.map_bias(light_projection, size, reads)
  local map = map_pass.kept(r, bias.read, size, gl.LEQUAL, r.texels)

  if bias.read then
    pass("1. the map", function()
      map_pass.draw(r, r.frame, size, scene.caster, r.depth, light_view, light_projection, bias)
    end)
  end

  pass("2. the scene, with " .. #taps .. " taps", function()
    local view, projection = camera:view(), camera:projection(r.width / r.height)
    gl.BindTexture(gl.TEXTURE_2D, map)
    gl.ClearColor(0.85, 0.88, 0.92, 1)
    gl.Enable(gl.DEPTH_TEST)
    gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
    draw_lit(scene, r.mapped, {
      view = view, projection = projection, light = light, shadow_map = 0,
      light_matrix = shadow.bias_matrix() * light_projection * light_view * view:inverse(),
      reach = (r.params.hardware and 1 or 0.5) / size,
      taps = #taps, places = taps, texel = 1 / size, rotated = r.params.pattern == "rotated",
    })
  end)
end

return recipe
