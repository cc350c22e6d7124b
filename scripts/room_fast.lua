-- The lab's room, the same picture in a fraction of the time. Redrawing it for each place of the light
-- costs a million small triangles; what changes from one to the next is where the light is hidden:
--   - so only that is drawn for each point, and summed in a texture of floats; the scene is shaded once;
--   - a caster's shadow on a wall is its silhouette, flattened and filled by winding: some hundred
--     edges, counted up and down in the stencil, where the caster has thousands of triangles;
--   - walls and casters that cannot meet are skipped.
-- Shading is that of the light's centre: that, and no more, differs. Shadows are always clipped to their wall.
local halves = require "parts.halves"
local lab_room = require "parts.lab_room"
local lamp = require "parts.lamp"
local lecture = require "room"

local recipe = {
  title   = "The lab's room, visibility alone and the scene shaded once",
  lecture = "beyond the lectures, beside 002_b957b372f85420d1: OpenGL (Soft) Shadows",
  scene   = "room",
  truth   = "soft on receivers",
  params  = {
    -- Over 0: the points grow from few, each time to twice as many, until this error of visibility over the
    -- picture is estimated; `jitters` is not asked then.
    error = param.number(0, 0, 1),
    most  = param.integer(4096, 16, 65536),  -- points that may be spent on it
  },
  keys    = lecture.keys,
  sweep   = lecture.sweep,
  holds   = lecture.holds,
  points  = lecture.points,  -- where their number does not grow
}
for name, parameter in pairs(lecture.params) do recipe.params[name] = parameter end

-- A framebuffer of two textures of floats, how many points are hidden and how many orbs are seen, with
-- depth and stencil.
function recipe.setup(r)
  r.gouraud = shader.load "gouraud"
  r.planar = shader.load "planar"
  r.flat = shader.load "flat"
  r.orb = shader.load "orb"
  r.sphere = mesh.sphere(1, 24, 12)
  r.quad = mesh.quad()
  r.frame, r.hidden = fbo.color(r.width, r.height, gl.R32F)
  r.orbs = gl.GenTextures(1)
  gl.BindTexture(gl.TEXTURE_2D, r.orbs)
  gl.TexStorage2D(gl.TEXTURE_2D, 1, gl.R32F, r.width, r.height)
  gl.BindFramebuffer(gl.FRAMEBUFFER, r.frame)
  gl.FramebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT1, gl.TEXTURE_2D, r.orbs, 0)
  local depth = gl.GenRenderbuffers(1)
  gl.BindRenderbuffer(gl.RENDERBUFFER, depth)
  gl.RenderbufferStorage(gl.RENDERBUFFER, gl.DEPTH24_STENCIL8, r.width, r.height)
  gl.FramebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_STENCIL_ATTACHMENT, gl.RENDERBUFFER, depth)
  gl.BindFramebuffer(gl.FRAMEBUFFER, 0)
  halves.setup(r)
end

-- The pixels where a wall is seen get bit 7: only there are its shadows counted.
local function mark(r, wall, seen)
  gl.StencilMask(0xFF)
  gl.Clear(gl.STENCIL_BUFFER_BIT)
  gl.Enable(gl.DEPTH_TEST)
  gl.DepthFunc(gl.EQUAL)
  gl.ColorMask(false, false, false, false)
  gl.StencilFunc(gl.ALWAYS, 0x80, 0xFF)
  gl.StencilOp(gl.KEEP, gl.KEEP, gl.REPLACE)
  lab_room.wall_mesh(r, wall, 1):draw(r.flat, { view = seen.view, projection = seen.projection, model = wall.model })
  gl.Disable(gl.DEPTH_TEST)
end

local function draw_wall(r, wall, seen)
  lab_room.wall_mesh(r, wall, 1):draw(r.flat, { view = seen.view, projection = seen.projection, model = wall.model,
                                                color = vec3(1) })
end

local function side_of(plane, point) return plane:dot(point) >= 0 and 1 or -1 end

-- The outlines of one point's shadows, counted up and down in bits 0 to 6.
local function count(r, wall, point, outline, caster, seen)
  local model = seen.models[caster]
  gl.ColorMask(false, false, false, false)
  gl.StencilMask(0x7F)
  gl.StencilFunc(gl.EQUAL, 0x80, 0x80)
  gl.StencilOpSeparate(gl.FRONT, gl.KEEP, gl.KEEP, gl.INCR_WRAP)
  gl.StencilOpSeparate(gl.BACK, gl.KEEP, gl.KEEP, gl.DECR_WRAP)
  gl.Enable(gl.CLIP_DISTANCE0)
  gl.Enable(gl.DEPTH_CLAMP)  -- as in room: depths are not asked
  outline:draw(r.planar, { view = seen.view, projection = seen.projection,
                           model = shadow.planar(wall.plane, point) * model,
                           above = model:transpose() * shadow.plane_toward(wall.plane, point) })
  gl.Disable(gl.CLIP_DISTANCE0)
  gl.Disable(gl.DEPTH_CLAMP)
  -- Of a light in the caster's box the same number is missing everywhere; seen from behind, counts are turned.
  local missing = outline.offset * side_of(wall.plane, point) * side_of(wall.plane, vec4(r.scene.camera.eye, 1))
  gl.StencilOp(gl.KEEP, gl.KEEP, missing > 0 and gl.INCR_WRAP or gl.DECR_WRAP)
  for _ = 1, math.abs(missing) do draw_wall(r, wall, seen) end
end

-- One more point is hidden where the count is not zero; it is zero again for what comes next. Where more of
-- the same point follows, a pixel loses its mark, or it would be hidden twice.
local function add(r, wall, mask, seen)
  gl.ColorMask(true, true, true, true)
  gl.StencilMask(mask)
  gl.StencilFunc(gl.NOTEQUAL, 0, 0x7F)
  gl.StencilOp(gl.KEEP, gl.KEEP, gl.ZERO)
  draw_wall(r, wall, seen)
end

local function add_wall(r, wall, points, first, last, seen)
  local marked = false
  for k = first, last do
    local point = points[k]
    local layers, parted = 0, false
    for i, caster in ipairs(r.scene.casters) do
      for _, outline in ipairs(shadow.outlines(caster, seen.models[i], point, wall)) do
        if not marked then
          mark(r, wall, seen)
          marked = true
        end
        if layers + outline.layers > 127 then
          add(r, wall, 0xFF, seen)
          layers, parted = 0, true
        end
        count(r, wall, point, outline, i, seen)
        layers = layers + outline.layers
      end
    end
    if layers > 0 then add(r, wall, 0x7F, seen) end
    if parted then mark(r, wall, seen) end
  end
end

local function draw_depth(r, walls, seen)
  gl.DrawBuffers(2, { gl.COLOR_ATTACHMENT0, gl.COLOR_ATTACHMENT1 })
  gl.ClearColor(0, 0, 0, 0)
  gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
  gl.Enable(gl.DEPTH_TEST)
  gl.ColorMask(false, false, false, false)
  for _, wall in ipairs(walls) do
    lab_room.wall_mesh(r, wall, 1):draw(r.flat, { view = seen.view, projection = seen.projection, model = wall.model })
  end
  for i, caster in ipairs(r.scene.casters) do
    caster:draw(r.flat, { view = seen.view, projection = seen.projection, model = seen.models[i] })
  end
  gl.DepthMask(false)
end

local function add_orbs(r, points, count, seen)
  gl.DrawBuffer(gl.COLOR_ATTACHMENT1)
  gl.Enable(gl.DEPTH_TEST)
  gl.DepthFunc(gl.LESS)
  gl.Enable(gl.CULL_FACE)
  for k = 1, count do
    r.sphere:draw(r.flat, { view = seen.view, projection = seen.projection, color = vec3(1),
                              model = lab_room.orb_model(r, points[k]) })
  end
  gl.Disable(gl.CULL_FACE)
end

local function shade(r, walls, count, seen)
  gl.BindFramebuffer(gl.FRAMEBUFFER, 0)
  gl.DepthMask(true)
  gl.ClearColor(0.10, 0.11, 0.14, 1)
  gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
  gl.BindTexture(gl.TEXTURE_2D, r.hidden)
  for _, wall in ipairs(walls) do
    lab_room.wall_mesh(r, wall, r.params.tessellation):draw(r.gouraud, {
      view = seen.view, projection = seen.projection, light = seen.light, model = wall.model, color = wall.color,
      ambient = r.params.darkness, hidden = 0, points = count,
    })
  end
  for i, caster in ipairs(r.scene.casters) do
    caster:draw(r.gouraud, { view = seen.view, projection = seen.projection, light = seen.light,
                             model = seen.models[i], ambient = r.params.darkness, points = 0 })
  end
  gl.BindTexture(gl.TEXTURE_2D, r.orbs)
  gl.Disable(gl.DEPTH_TEST)
  gl.Enable(gl.BLEND)
  gl.BlendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA)
  gl.ColorMask(true, true, true, false)
  r.quad:draw(r.orb, { color = lab_room.orb_color, covered = 0, points = count })
end

-- From how many of the points first to last each wall's pixels are hidden, added to what is there.
local function add_points(r, walls, points, first, last, seen)
  gl.BindFramebuffer(gl.FRAMEBUFFER, r.frame)
  gl.Enable(gl.STENCIL_TEST)
  gl.Enable(gl.SCISSOR_TEST)
  gl.Enable(gl.BLEND)
  gl.BlendFunc(gl.ONE, gl.ONE)
  gl.DrawBuffer(gl.COLOR_ATTACHMENT0)
  for _, wall in ipairs(walls) do
    pass("2. from how many of the points " .. first .. " to " .. last .. " " .. wall.name .. " is hidden", function()
      gl.Scissor(lab_room.pixels(r, wall, seen))
      add_wall(r, wall, points, first, last, seen)
    end)
  end
  gl.Disable(gl.STENCIL_TEST)
  gl.Disable(gl.SCISSOR_TEST)
end

-- Points of a nested pattern until the error is what is asked for; gives them, and how many.
local function grow(r, walls, seen)
  local params = r.params
  local light = lamp(params.light, params.shape, params.radius)
  -- Nested, so that what is counted stays; and at random, so that two halves err apart.
  local pattern = params.pattern == "random" and "random" or "owen"
  -- An estimate by few points is uncertain: of 16 at least, and of half of what the penumbra lets expect.
  local expected = shadow.samples_needed(r.scene, r.scene.camera, light, params.error)
  local count, reached = math.max(8, expected // 4), false
  while 2 * count > params.most do count = count // 2 end
  local points = shadow.samples(light, count, pattern, params.seed)
  add_points(r, walls, points, 1, count, seen)
  while not reached and 2 * count <= params.most do
    halves.keep(r, r.frame)
    points = shadow.samples(light, 2 * count, pattern, params.seed)
    add_points(r, walls, points, count + 1, 2 * count, seen)
    count = 2 * count
    pass("what " .. count .. " points have for an error", function()
      gl.Disable(gl.BLEND)
      gl.ColorMask(true, true, true, true)
      local error = halves.error(r, r.hidden, count)
      reached = error <= params.error
      explain(string.format("%d points of %s: by their halves the error over the picture is %.2g, where %g was asked for: %s",
                            count, pattern, error, params.error, reached and "enough." or "twice as many."))
    end)
  end
  gl.BindFramebuffer(gl.FRAMEBUFFER, r.frame)
  return points, count
end

function recipe.draw(r)
  local camera, walls = r.scene.camera, lab_room.walls(r)
  local seen = { view = camera:view(), projection = camera:projection(r.width / r.height), light = r.params.light,
                 models = lab_room.models(r) }
  gl.BindFramebuffer(gl.FRAMEBUFFER, r.frame)
  pass("1. what is seen, in the depth buffer", function() draw_depth(r, walls, seen) end)

  local points, count
  if r.params.soft and r.params.error > 0 and r.params.radius > 0 then
    points, count = grow(r, walls, seen)
  else
    points = lab_room.points(r)
    count = #points
    add_points(r, walls, points, 1, count, seen)
  end

  pass("3. how many of the light's places are seen", function()
    gl.Enable(gl.BLEND)
    gl.ColorMask(true, true, true, true)
    add_orbs(r, points, count, seen)
    gl.Disable(gl.BLEND)
  end)

  pass("4. the scene, shaded once", function() shade(r, walls, count, seen) end)
end

return recipe
