-- What a light's size does to a shadow. The light is drawn as many points, each with its hard shadow,
-- and the pictures are averaged: dark where no point is seen (umbra), in between where some are
-- (penumbra). Make the light larger: the penumbra grows and the umbra shrinks, until there is none. Lower
-- the caster: the penumbra shrinks to nothing where it touches. With radius 0 there is none at all.
local lamp = require "parts.lamp"

local recipe = {
  title   = "Umbra and penumbra",
  lecture = "000_178f3ee06912f876: Umbra i penumbra",
  scene   = "plate",
  params  = {
    light    = param.point(0.2, 3, 0.1),
    radius   = param.number(0.4, 0, 4),       -- of the light; half the side of a square one
    shape    = param.choice("square", "disk", "sphere"),
    lift     = param.number(0, -1, 2),        -- of the caster, from where its scene has it
    samples  = param.integer(64, 1, 4096),
    pattern  = param.choice("hammersley", "random", "jitter", "grid", "r2", "sobol", "owen"),
    darkness = param.number(0.25, 0, 1),
  },
  keys    = { h = "add light -0.1 0 0", l = "add light 0.1 0 0", j = "add light 0 -0.1 0",
              k = "add light 0 0.1 0", ["+"] = "multiply radius 1.25", ["-"] = "multiply radius 0.8",
              u = "add lift 0.05", d = "add lift -0.05", s = "next shape" },
  sweep   = { samples = { 1, 4, 16, 64, 256 } },
}

function recipe.setup(r)
  r.phong = shader.load "phong"
  r.planar = shader.load "planar"
end

-- The scene with the hard shadow of one point, as in projected_stencil.
local function draw_hard(r, light)
  local scene = r.scene
  local view, projection = scene.camera:view(), scene.camera:projection(r.width / r.height)
  local lift = mat4.translate(0, r.params.lift, 0)
  gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT)

  gl.Enable(gl.STENCIL_TEST)
  gl.StencilOp(gl.KEEP, gl.KEEP, gl.REPLACE)
  for number, receiver in ipairs(scene.receivers) do
    gl.StencilFunc(gl.ALWAYS, number, 0xFF)
    receiver:draw(r.phong, { view = view, projection = projection, light = light,
                             lit = 1, ambient = r.params.darkness })
  end

  gl.Disable(gl.DEPTH_TEST)
  gl.ColorMask(false, false, false, false)
  gl.StencilOp(gl.KEEP, gl.KEEP, gl.ZERO)
  gl.Enable(gl.CLIP_DISTANCE0)
  for number, receiver in ipairs(scene.receivers) do
    gl.StencilFunc(gl.EQUAL, number, 0xFF)
    local onto_plane = shadow.planar(receiver.plane, light)
    local above = shadow.plane_toward(receiver.plane, light)
    for _, caster in ipairs(scene.casters) do
      local model = lift * caster.model
      caster:draw(r.planar, { view = view, projection = projection, model = onto_plane * model,
                              above = model:transpose() * above })
    end
  end
  gl.Disable(gl.CLIP_DISTANCE0)
  gl.ColorMask(true, true, true, true)
  gl.Enable(gl.DEPTH_TEST)

  gl.DepthFunc(gl.LEQUAL)
  gl.StencilFunc(gl.EQUAL, 0, 0xFF)
  gl.StencilOp(gl.KEEP, gl.KEEP, gl.KEEP)
  scene.receiver:draw(r.phong, { view = view, projection = projection, light = light,
                                 lit = 0, ambient = r.params.darkness })
  gl.DepthFunc(gl.LESS)
  gl.Disable(gl.STENCIL_TEST)
  for _, caster in ipairs(scene.casters) do
    caster:draw(r.phong, { view = view, projection = projection, light = light,
                           model = lift * caster.model, lit = 1, ambient = r.params.darkness })
  end
end

function recipe.draw(r)
  local light = lamp(r.params.light, r.params.shape, r.params.radius)
  local points = shadow.samples(light, r.params.samples, r.params.pattern)

  gl.ClearColor(0.85, 0.88, 0.92, 1)
  gl.Enable(gl.DEPTH_TEST)
  -- Pictures of 8 bits are averaged to 8 bits: what 16 would lose (recipe banding) is not in this one.
  fbo.accumulation "float32"
  gl.Clear(gl.ACCUM_BUFFER_BIT)
  for i, point in ipairs(points) do
    pass("the hard shadow of point " .. i .. " of " .. #points, function()
      draw_hard(r, point)
      gl.Accum(gl.ACCUM, 1 / #points)
    end)
  end

  pass("the average", function()
    gl.Accum(gl.RETURN, 1)
  end)
end

return recipe
