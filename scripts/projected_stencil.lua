-- The shadow of the casters on each plane, clipped to it and darkened once: four passes, and the
-- stencil buffer tells where a receiver is lit (its number) from where it is in shadow (0).
--
-- Receivers shadow none of the casters and none of each other: that is not in this technique.
local recipe = {
  title   = "Projected shadow, clipped by the stencil buffer",
  lecture = "000_178f3ee06912f876: Ombres per projecció (amb stencil)",
  scene   = "table",
  params  = {
    light    = param.point(2, 4, 1),
    darkness = param.number(0.35, 0, 1),   -- what is left of a receiver's colour in the shadow
  },
  keys    = { s = "toggle darkness 0 0.35" },
}

function recipe.setup(r)
  r.phong = shader.load "phong"
  r.planar = shader.load "planar"
end

function recipe.draw(r)
  local scene, light = r.scene, r.params.light
  local view, projection = scene.camera:view(), scene.camera:projection(r.width / r.height)

  gl.ClearColor(0.85, 0.88, 0.92, 1)
  gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT)
  gl.Enable(gl.DEPTH_TEST)

  -- The slide has one receiver and writes 1. The mask is of all bits: with 1 alone, the second
  -- receiver's 2 would be stored whole but compared as 0.
  pass("1. the receivers mark the stencil", function()
    gl.Enable(gl.STENCIL_TEST)
    gl.StencilOp(gl.KEEP, gl.KEEP, gl.REPLACE)
    for number, receiver in ipairs(scene.receivers) do
      gl.StencilFunc(gl.ALWAYS, number, 0xFF)
      receiver:draw(r.phong, { view = view, projection = projection, light = light,
                               ambient = r.params.darkness })
    end
  end)

  -- No depth test: the projected caster lies in the receiver's plane, and the mark tells where the
  -- receiver is in front. The slide projects all of the caster; what is below the plane would then
  -- throw a shadow up at it, so here a clip distance cuts it off.
  pass("2. the projected casters clear it where the shadow falls", function()
    gl.Disable(gl.DEPTH_TEST)
    gl.ColorMask(false, false, false, false)
    gl.StencilOp(gl.KEEP, gl.KEEP, gl.ZERO)
    gl.Enable(gl.CLIP_DISTANCE0)
    for number, receiver in ipairs(scene.receivers) do
      gl.StencilFunc(gl.EQUAL, number, 0xFF)
      local onto_plane = shadow.planar(receiver.plane, light)
      local above = shadow.plane_toward(receiver.plane, light)
      for _, caster in ipairs(scene.casters) do
        caster:draw(r.planar, { view = view, projection = projection,
                                model = onto_plane * caster.model,
                                above = caster.model:transpose() * above })
      end
    end
    gl.Disable(gl.CLIP_DISTANCE0)
  end)

  -- LEQUAL: the receiver is drawn again, at its own depth. The slide leaves ZERO as the operation,
  -- which does no harm here only because it writes 0 over 0.
  pass("3. the dark part of the receivers", function()
    gl.Enable(gl.DEPTH_TEST)
    gl.DepthFunc(gl.LEQUAL)
    gl.ColorMask(true, true, true, true)
    gl.StencilFunc(gl.EQUAL, 0, 0xFF)
    gl.StencilOp(gl.KEEP, gl.KEEP, gl.KEEP)
    scene.receiver:draw(r.phong, { view = view, projection = projection, light = light,
                                   lit = 0, ambient = r.params.darkness })
  end)

  pass("4. the casters", function()
    gl.DepthFunc(gl.LESS)
    gl.Disable(gl.STENCIL_TEST)
    scene.caster:draw(r.phong, { view = view, projection = projection, light = light,
                                 ambient = 0.25, lit = 1 })
  end)
end

return recipe
