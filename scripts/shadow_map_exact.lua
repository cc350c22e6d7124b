-- A hard shadow with no aliasing at all from the light's view, said to be too slow to be taught: an
-- ordinary map keeps one depth for a texel and lets every point of it share that. Here a cell of the
-- light's grid keeps the triangles that reach into it, and every fragment is tested against the shadows
-- of those in its own place: no texel, no bias, no contact gap. It is the dual of G. Johnson et al., The
-- Irregular Z-Buffer, 2005, and T. Aila, S. Laine, Alias-Free Shadow Maps, 2004, which keep the view's
-- samples in the light's grid and run over the casters; the test is the one of E. Sintorn et al., An
-- Efficient Alias-free Shadow Algorithm, 2011.
--
-- While light and casters are still the grid is kept, with fit = scene whatever the camera does; its
-- size is a matter of speed alone, not of the picture.
local map_limit = require "parts.map_limit"
local scene_depth = require "parts.scene_depth"
local still = require "parts.still"

local recipe = {
  title   = "A shadow map without aliasing",
  lecture = "003_dcbdf1292070997a: Problemas del Shadow Mapping, aliasing",
  scene   = "table",
  truth   = "hard",
  params  = {
    light = param.point(2, 4, 1),
    cells = param.integer(256, 1, 1024),     -- of a side of the grid
    fit   = param.choice("view", "scene"),   -- the grid: over what is seen, or over all for any camera
    count = param.toggle(false),             -- shows how many triangles each fragment is tested against
  },
  sweep   = { cells = { 32, 64, 128, 256, 512 } },
}

function recipe.holds(r)
  return pcall(shadow.light_view, r.params.light, r.scene, { fit = r.params.fit })
end

-- A bound, far above what two floats leave: 1e-5 of the map's side, and 34 steps of 24 bits in depth. Who is
-- seen is decided by scene_depth, which pulls receivers by two steps.
function recipe.limit(r)
  local _, projection = shadow.light_view(r.params.light, r.scene)
  local limit = map_limit({ { projection = projection } }, 1e5)
  limit.light_units, limit.eye_units = 34, 2
  return limit
end

function recipe.setup(r)
  r.cells = r.params.cells
  r.flat = shader.load "flat"
  r.exact = shader.load "shadow_map_exact"
  r.ranges, r.list, r.triangles = gl.GenTextures(3)
  r.shown = {}
end

local function upload(texture, internal, format, image)
  gl.BindTexture(gl.TEXTURE_2D, texture)
  gl.TexImage2D(gl.TEXTURE_2D, 0, internal, image.width, image.height, 0, format, gl.FLOAT, image.bytes)
  gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST)
  gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST)
end

-- A grid of one cell and no triangle.
local function empty(origin)
  return { origin = origin, ranges = { width = 1, height = 1, bytes = { 0, 0 } },
           list = { width = 1, height = 1, bytes = { 0 } },
           triangles = { width = 1, height = 1, bytes = { 0, 0, 0, 0 } } }
end

-- Doubles' first 24 bits, which a float holds, and their next (T. Dekker, 1971), at the tables' ends.
local function split(values, high, low)
  for _, value in ipairs(values) do
    local first = value * (2.0 ^ 29 + 1)
    first = first - (first - value)
    high[#high + 1], low[#low + 1] = first, value - first
  end
end

-- From the eye to pixel 0, 0 at a depth of 1, and from one to the next, world axes.
local function rays(camera, width, height)
  local to_world, half = camera:view():inverse(), math.tan(math.rad(camera.fovy) / 2)
  local right = to_world:column(1).xyz * (half * width / height)
  local up, back = to_world:column(2).xyz * half, to_world:column(3).xyz
  return -back - right - up, right * (2 / width), up * (2 / height)
end

function recipe.draw(r)
  local scene, camera, light, cells = r.scene, r.scene.camera, r.params.light, r.cells
  local light_view, light_projection = shadow.light_view(light, scene, { fit = r.params.fit })

  -- For a frame in which nobody reads it the grid is one cell, and empty.
  local bias = shadow.map_bias(light_projection, cells)
  local read = bias.read
  if r.read ~= read then r.read, r.shown = read, {} end

  if not still(r.shown, light_projection * light_view, scene.casters) then
    pass("1. the casters' triangles, into the light's grid", function()
      local grid = read and shadow.triangle_grid(light, scene, light_view, light_projection, cells) or empty(camera.eye)
      upload(r.ranges, gl.RG32F, gl.RG, grid.ranges)
      upload(r.list, gl.R32F, gl.RED, grid.list)
      upload(r.triangles, gl.RGBA32F, gl.RGBA, grid.triangles)
      r.origin = grid.origin
    end)
  end

  local view, projection = camera:view(), camera:projection(r.width / r.height)
  local seen, fronts = { view = view, projection = projection, light = light }, nil
  gl.ClearColor(0.85, 0.88, 0.92, 1)
  gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT)
  gl.Enable(gl.DEPTH_TEST)

  pass("2. the scene in the depth buffer", function()
    gl.ColorMask(false, false, false, false)
    fronts = scene_depth.draw(scene.objects, r.flat, seen)
    gl.ColorMask(true, true, true, true)
  end)

  for i, texture in ipairs { r.ranges, r.list, r.triangles } do
    gl.ActiveTexture(gl.TEXTURE0 + i - 1)
    gl.BindTexture(gl.TEXTURE_2D, texture)
  end
  local grid_to_map = shadow.bias_matrix() * light_projection * light_view * mat4.translate(r.origin)
  scene_depth.match()

  pass("3. each fragment against its cell's triangles", function()
    gl.Disable(gl.STENCIL_TEST)
    local map_high, map_low, ray_high, ray_low = {}, {}, {}, {}
    for column = 1, 4 do
      local c = grid_to_map:column(column)
      split({ c.x, c.y, c.z, c.w }, map_high, map_low)
    end
    for _, v in ipairs { camera.eye - r.origin, rays(camera, r.width, r.height) } do
      split({ v.x, v.y, v.z }, ray_high, ray_low)
    end
    local uniforms = {
      view = view, projection = projection, light = light, ranges = 0, list = 1, triangles = 2,
      eye_to_grid = mat4.translate(-r.origin) * view:inverse(), map_high = map_high, map_low = map_low,
      ray_high = ray_high, ray_low = ray_low, count = r.params.count, first_own = 0,
      depth_step = 8 / (camera.near * 2 ^ 24), cell = bias.texel,
    }
    -- Their triangles are numbered through, as the grid has them.
    for _, object in ipairs(scene.objects) do
      uniforms.casts = read and object.role ~= "receiver"
      if fronts[object] then gl.Enable(gl.CULL_FACE) else gl.Disable(gl.CULL_FACE) end
      object:draw(r.exact, uniforms)
      uniforms.first_own = uniforms.first_own + object.mesh.triangles
    end
  end)
end

return recipe
