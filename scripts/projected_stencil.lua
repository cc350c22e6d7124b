-- The shadow of a caster on a plane, clipped to the receiver and darkened once: four passes, and
-- the stencil buffer tells lit (1) from shadowed (0).
local recipe = {
  title   = "Projected shadow, clipped by the stencil buffer",
  lecture = "000_178f3ee06912f876: Ombres per projecció (amb stencil)",
  scene   = "table",
  params  = {
    light    = param.point(2, 4, 1),
    darkness = param.number(0.35, 0, 1),
  },
  keys    = { s = "toggle darkness 0 0.35" },
}

function recipe.setup(r)
  r.phong = shader.load "phong"
  r.flat = shader.load "flat"
end

function recipe.draw(r)
  local scene, light = r.scene, r.params.light
  local view, projection = scene.camera:view(), scene.camera:projection(r.width / r.height)
  local receiver = scene.receivers[1]

  gl.ClearColor(0.85, 0.88, 0.92, 1)
  gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT)
  gl.Enable(gl.DEPTH_TEST)

  pass("1. the receiver marks the stencil", function()
    gl.Enable(gl.STENCIL_TEST)
    gl.StencilFunc(gl.ALWAYS, 1, 1)
    gl.StencilOp(gl.KEEP, gl.KEEP, gl.REPLACE)
    receiver:draw(r.phong, { view = view, projection = projection, light = light })
  end)

  -- No depth test: the projected caster lies in the receiver's plane. Where it is behind the
  -- receiver's other side nothing was marked, so nothing can be cleared.
  pass("2. the projected caster clears it where the shadow falls", function()
    gl.Disable(gl.DEPTH_TEST)
    gl.ColorMask(false, false, false, false)
    gl.StencilFunc(gl.EQUAL, 1, 1)
    gl.StencilOp(gl.KEEP, gl.KEEP, gl.ZERO)
    local onto_plane = shadow.planar(receiver.plane, light)
    for _, caster in ipairs(scene.casters) do
      caster:draw(r.flat, { view = view, projection = projection, model = onto_plane * caster.model })
    end
  end)

  pass("3. the dark part of the receiver", function()
    gl.Enable(gl.DEPTH_TEST)
    gl.DepthFunc(gl.LEQUAL)
    gl.ColorMask(true, true, true, true)
    gl.StencilFunc(gl.EQUAL, 0, 1)
    gl.StencilOp(gl.KEEP, gl.KEEP, gl.KEEP)
    receiver:draw(r.phong, { view = view, projection = projection, light = light,
                             lit = 0, ambient = r.params.darkness })
  end)

  pass("4. the caster", function()
    gl.DepthFunc(gl.LESS)
    gl.Disable(gl.STENCIL_TEST)
    scene.caster:draw(r.phong, { view = view, projection = projection, light = light,
                                 ambient = 0.25, lit = 1 })
  end)
end

return recipe
