-- The shadow of a light with a size: hard shadows of N points on it, averaged in the accumulation buffer.
-- Any hard shadow will do, and any set of points; their error against all of the light falls with N, for
-- random points as N^-1/2, for those that are spread evenly as N^-0.7 or so. Of a number that is fixed,
-- Hammersley's are the best on average (bench_soft); a set that is to grow needs a nested pattern.
--   volumes  counted by z-fail for each point; right wherever a point's shadow is
--   maps     a shadow map for each point; a point among its casters has none
-- The storage says what the average loses: recipe banding.
local batches_of = require "parts.batches"
local draw_lit = require "parts.draw_lit"
local lamp = require "parts.lamp"
local map_limit = require "parts.map_limit"
local map_pass = require "parts.map_pass"
local own_shadow = require "parts.own_shadow"
local scene_depth = require "parts.scene_depth"

local recipe = {
  title   = "Soft shadows, accumulated",
  lecture = "002_b957b372f85420d1: Soft shadows; 003_dcbdf1292070997a",
  scene   = "table",
  truth   = "soft",
  params  = {
    light     = param.point(2, 4, 1),
    radius    = param.number(0.25, 0, 4),       -- of the light; half the side of a square one
    shape     = param.choice("sphere", "square", "disk"),
    technique = param.choice("volumes", "maps"),
    samples   = param.integer(16, 1, 4096),
    -- Over 0: as many points of "owen" as its penumbra needs for this error of visibility over the picture.
    error     = param.number(0, 0, 1),
    pattern   = param.choice("hammersley", "random", "jitter", "grid", "r2", "sobol", "owen"),
    seed      = param.integer(1, 0, 1000000),   -- 0 is the truth's
    storage   = param.choice("snorm16", "snorm8", "float16", "float32"),
    size      = param.integer(1024, 16, 4096),  -- of the maps
    darkness  = param.number(0.25, 0, 1),
  },
  keys      = { ["["] = "multiply samples 0.5", ["]"] = "multiply samples 2", p = "next pattern",
                t = "next technique", ["+"] = "multiply radius 1.25", ["-"] = "multiply radius 0.8" },
  sweep     = { samples = { 1, 4, 16, 64, 256 } },
}

local function points_of(r)
  local params = r.params
  local light = lamp(params.light, params.shape, params.radius)
  if params.error == 0 or params.radius == 0 then
    return shadow.samples(light, params.samples, params.pattern, params.seed)
  end
  local needed = shadow.samples_needed(r.scene, r.scene.camera, light, params.error)
  return shadow.samples(light, math.min(needed, 4096), "owen", params.seed)
end

-- A lamp has a radius; for a direction there is none. Each map needs its point outside of the casters.
function recipe.holds(r)
  if r.params.light.w == 0 then return false end
  if r.params.technique == "volumes" then return true end
  for _, point in ipairs(points_of(r)) do
    if not pcall(shadow.light_view, point, r.scene) then return false end
  end
  return true
end

recipe.points = points_of

-- Of each point's hard shadow.
function recipe.limit(r)
  if r.params.technique == "volumes" then return scene_depth.limit() end
  local maps = {}
  for i, point in ipairs(points_of(r)) do
    local _, projection = shadow.light_view(point, r.scene)
    maps[i] = { projection = projection }
  end
  return map_limit(maps, r.params.size)
end

function recipe.setup(r)
  r.size = r.params.size
  r.phong = shader.load "phong"
  r.volume = shader.load "volume"
  r.flat = shader.load "flat"
  r.mapped = shader.load "shadow_map"
  r.quad = mesh.quad()
end

-- The passes of volumes_zfail.
local function draw_volumes(r, seen, light)
  local scene, batches = r.scene, batches_of(r.scene.casters, light)
  local at = { view = seen.view, projection = seen.projection, light = light }
  gl.StencilMask(0xFF)
  gl.DepthMask(true)
  gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT)
  gl.Enable(gl.DEPTH_TEST)
  gl.DepthFunc(gl.LESS)
  gl.ColorMask(false, false, false, false)
  scene_depth.draw(scene.objects, r.phong, at)
  gl.DepthMask(false)
  local volumes = {}
  for _, batch in ipairs(batches) do
    for _, drawn in ipairs(batch) do
      drawn.volume = shadow.volume(drawn.caster, nil, light, { part = drawn.part })
      table.insert(volumes, drawn.volume)
    end
  end
  own_shadow(volumes, r.volume, at)
  for _, batch in ipairs(batches) do
    gl.StencilFunc(gl.ALWAYS, 0, 0)
    gl.StencilOpSeparate(gl.BACK, gl.KEEP, gl.INCR_WRAP, gl.KEEP)
    gl.StencilOpSeparate(gl.FRONT, gl.KEEP, gl.DECR_WRAP, gl.KEEP)
    for _, drawn in ipairs(batch) do drawn.volume:draw(r.volume, at) end
    if #batches > 1 then
      gl.StencilMask(0xFF)
      gl.StencilFunc(gl.NOTEQUAL, 0x80, 0x7F)
      gl.StencilOp(gl.KEEP, gl.KEEP, gl.REPLACE)
      gl.Disable(gl.DEPTH_TEST)
      r.quad:draw(r.flat)
      gl.Enable(gl.DEPTH_TEST)
      gl.StencilMask(0x7F)
    end
  end
  gl.ColorMask(true, true, true, true)
  gl.StencilOp(gl.KEEP, gl.KEEP, gl.KEEP)
  scene_depth.match()
  at.ambient = r.params.darkness
  for _, part in ipairs{ { gl.NOTEQUAL, 0 }, { gl.EQUAL, 1 } } do
    gl.StencilFunc(part[1], 0, 0xFF)
    at.lit = part[2]
    scene:draw(r.phong, at)
  end
  gl.Disable(gl.STENCIL_TEST)
  gl.Disable(gl.POLYGON_OFFSET_FILL)
end

-- The passes of shadow_map_fbo.
local function draw_map(r, seen, light)
  local light_view, light_projection = shadow.light_view(light, r.scene)
  gl.DepthMask(true)
  gl.DepthFunc(gl.LESS)
  local bias = shadow.map_bias(light_projection, r.size)
  local map = map_pass.kept(r, bias.read, r.size)
  if bias.read then
    map_pass.draw(r, r.frame, r.size, r.scene.caster, r.flat, light_view, light_projection, bias)
  end
  gl.Enable(gl.DEPTH_TEST)
  gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
  gl.BindTexture(gl.TEXTURE_2D, map)
  draw_lit(r.scene, r.mapped, {
    view = seen.view, projection = seen.projection, light = light, shadow_map = 0, ambient = r.params.darkness,
    light_matrix = shadow.bias_matrix() * light_projection * light_view * seen.view:inverse(),
  })
end

function recipe.draw(r)
  local camera, points = r.scene.camera, points_of(r)
  local seen = { view = camera:view(), light = r.params.light,
                 projection = shadow.infinite_perspective(camera.fovy, r.width / r.height, camera.near) }

  gl.ClearColor(0.85, 0.88, 0.92, 1)
  fbo.accumulation(r.params.storage)
  gl.Clear(gl.ACCUM_BUFFER_BIT | gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)

  local draw_hard = r.params.technique == "volumes" and draw_volumes or draw_map
  for i, point in ipairs(points) do
    pass("the hard shadow of point " .. i .. " of " .. #points, function()
      draw_hard(r, seen, point)
      gl.Accum(gl.ACCUM, 1 / #points)
    end)
  end

  pass("the average", function()
    gl.Accum(gl.RETURN, 1)
  end)
end

return recipe
