-- The lab's room: five walls, each a receiver with its own plane, a teapot, a torus, and a light among
-- them. A frame is hard shadows: for each wall, the wall and then the casters flattened onto it. Soft
-- ones are many such frames, each with the light jittered, averaged by the accumulation buffer.
--
-- Lighting is per vertex: with few quads a wall, a light near it is lost between its vertices.
--
-- Keys are the lab's; ESC closes the window, as with every recipe. The same picture sooner: room_fast.
local lab_room = require "parts.lab_room"

local recipe = {
  title   = "The lab: soft shadows in a room",
  lecture = "002_b957b372f85420d1: OpenGL (Soft) Shadows",
  scene   = "room",
  truth   = "soft on receivers",
  params  = {
    light        = param.point(0.2, 2.1, 0.9),
    soft         = param.toggle(true),
    jitters      = param.integer(16, 1, 4096),
    radius       = param.number(0.12, 0, 2),     -- how far the light is jittered
    shape        = param.choice("sphere", "square", "disk"),
    -- The lab jitters at random; points that are spread evenly need far fewer.
    pattern      = param.choice("hammersley", "random", "jitter", "grid", "r2", "sobol", "owen"),
    seed         = param.integer(1, 0, 1000000),
    storage      = param.choice("snorm16", "snorm8", "float16", "float32"),
    walls        = param.toggle(true),           -- false: the floor alone, and the light as a sun
    clip         = param.toggle(true),           -- shadows end where their wall does
    tessellation = param.integer(16, 1, 64),     -- quads along a wall's side; the lab begins with 4
    turn         = param.number(0, 0, 360),      -- of teapot and torus, degrees
    darkness     = param.number(0.25, 0, 1),
  },
  keys = {
    h = "add light -0.1 0 0", l = "add light 0.1 0 0", j = "add light 0 -0.1 0", k = "add light 0 0.1 0",
    b = "add light 0 0 -0.1", f = "add light 0 0 0.1", r = "add turn 10", s = "toggle soft",
    x = "toggle walls", c = "toggle clip", ["["] = "add jitters -1", ["]"] = "add jitters 1",
    [";"] = "multiply radius 0.8", ["'"] = "multiply radius 1.25",
    ["-"] = "add tessellation -1", ["+"] = "add tessellation 1",
  },
  sweep = { jitters = { 1, 4, 16, 64, 256 } },
}

-- A light at infinity cannot be jittered.
function recipe.holds(r) return r.params.light.w ~= 0 end

recipe.points = lab_room.points

function recipe.setup(r)
  r.gouraud = shader.load "gouraud"
  r.planar = shader.load "planar"
  r.orb = shader.load "orb"
  r.sphere = mesh.sphere(1, 24, 12)
end

-- A wall with the casters' shadows on it.
local function draw_wall(r, wall, casters, seen)
  if r.params.clip then
    gl.Clear(gl.STENCIL_BUFFER_BIT)
    gl.Enable(gl.STENCIL_TEST)
    gl.StencilFunc(gl.ALWAYS, 1, 0xFFFFFFFF)
    gl.StencilOp(gl.KEEP, gl.KEEP, gl.REPLACE)
  end
  lab_room.wall_mesh(r, wall, r.params.tessellation):draw(r.gouraud, { view = seen.view, projection = seen.projection, light = seen.light,
                                       model = wall.model, color = wall.color, ambient = r.params.darkness })
  -- In the wall's own plane the light throws no shadow at all.
  if math.abs(wall.plane:dot(seen.light)) < 1e-9 then return end

  -- Clipped, the stencil says where the wall is, so depths need not be compared. If not, they must be, or
  -- the shadow would lie over what is in front; it is then offset toward the viewer, against z-fighting.
  if r.params.clip then
    gl.StencilFunc(gl.EQUAL, 1, 0xFFFFFFFF)
    gl.StencilOp(gl.KEEP, gl.KEEP, gl.KEEP)
    gl.Disable(gl.DEPTH_TEST)
    -- Nor clipped: under a near plane of 1e-5 a float does not tell whether they are before the far one.
    gl.Enable(gl.DEPTH_CLAMP)
  else
    gl.Enable(gl.POLYGON_OFFSET_FILL)
    gl.PolygonOffset(-1, -1)
  end
  gl.Enable(gl.CLIP_DISTANCE0)
  local onto_wall = shadow.planar(wall.plane, seen.light)
  local above = shadow.plane_toward(wall.plane, seen.light)
  for i, caster in ipairs(r.scene.casters) do
    -- The lab's shadows are black. What the light leaves, the ambient part, is one colour for a wall.
    caster:draw(r.planar, { view = seen.view, projection = seen.projection, model = onto_wall * casters[i],
                            above = casters[i]:transpose() * above, color = wall.color * r.params.darkness })
  end
  gl.Disable(gl.CLIP_DISTANCE0)
  gl.Disable(gl.DEPTH_CLAMP)
  gl.Disable(gl.STENCIL_TEST)
  gl.Disable(gl.POLYGON_OFFSET_FILL)
  gl.Enable(gl.DEPTH_TEST)
end

-- The lab's drawScene, with the light at a point.
local function draw_scene(r, light)
  local camera = r.scene.camera
  local seen = { view = camera:view(), projection = camera:projection(r.width / r.height), light = light }
  local casters = lab_room.models(r)
  gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
  gl.Enable(gl.DEPTH_TEST)

  r.sphere:draw(r.orb, { view = seen.view, projection = seen.projection, color = lab_room.orb_color,
                         model = lab_room.orb_model(r, light) })
  for _, wall in ipairs(lab_room.walls(r)) do draw_wall(r, wall, casters, seen) end
  for i, caster in ipairs(r.scene.casters) do
    caster:draw(r.gouraud, { view = seen.view, projection = seen.projection, light = light,
                             model = casters[i], ambient = r.params.darkness })
  end
end

function recipe.draw(r)
  local light, params = r.params.light, r.params
  gl.ClearColor(0.10, 0.11, 0.14, 1)
  if not params.soft then
    pass("the scene with hard shadows", function() draw_scene(r, light) end)
    return
  end

  local points = lab_room.points(r)
  fbo.accumulation(params.storage)
  gl.Clear(gl.ACCUM_BUFFER_BIT)
  for i, point in ipairs(points) do
    pass("the scene with the light jittered, " .. i .. " of " .. #points, function()
      draw_scene(r, point)
      gl.Accum(gl.ACCUM, 1 / #points)
    end)
  end
  pass("the average", function()
    gl.Accum(gl.RETURN, 1)
  end)
end

return recipe
