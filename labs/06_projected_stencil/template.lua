-- Lab 06. The table and the teapot are drawn; the shadow is yours. Fill in the three places marked
-- TO DO, and leave the names of the passes as they are. README.md says what each of them needs.
local recipe = {
  title   = "Lab 06: a projected shadow in four passes, by stencil",
  lecture = "000_178f3ee06912f876: Ombres per projecció (amb stencil)",
  scene   = "table",
  truth   = "hard on receivers",
  params  = {
    light    = param.point(2, 4, 1),
    darkness = param.number(0.35, 0, 1),   -- what is left of the receiver's colour in the shadow
  },
}

function recipe.setup(r)
  r.phong = shader.load "phong"
  r.flat = shader.load "flat"
end

function recipe.draw(r)
  local scene, light, darkness = r.scene, r.params.light, r.params.darkness
  local receiver, caster = scene.receivers[1], scene.casters[1]
  local view, projection = scene.camera:view(), scene.camera:projection(r.width / r.height)

  gl.ClearColor(0.85, 0.88, 0.92, 1)
  gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT)
  gl.Enable(gl.DEPTH_TEST)

  pass("1. the receiver marks the stencil", function()
    -- TO DO: switch the stencil test on. Every fragment of the receiver that passes the depth test
    -- writes 1: gl.StencilFunc, gl.StencilOp.
    receiver:draw(r.phong, { view = view, projection = projection, light = light, ambient = darkness })
  end)

  pass("2. the projected caster clears it where the shadow falls", function()
    -- TO DO: no depth test, no colour. Where the stencil is 1, a fragment sets it to 0.
    -- Then draw the caster with r.flat. Its model matrix has two factors: first the caster's own,
    -- caster.model, then the projection onto the receiver, shadow.planar(receiver.plane, light).
  end)

  pass("3. the dark part of the receiver", function()
    -- TO DO: depth test and colours again. The receiver is drawn once more at the depth that it
    -- already has: which gl.DepthFunc lets it? Only where the stencil is 0; the stencil stays.
    -- Draw it as in pass 1, with lit = 0: what the shadow leaves.
  end)

  pass("4. the caster", function()
    gl.DepthFunc(gl.LESS)
    gl.Disable(gl.STENCIL_TEST)
    caster:draw(r.phong, { view = view, projection = projection, light = light, lit = 1, ambient = 0.25 })
  end)
end

return recipe
