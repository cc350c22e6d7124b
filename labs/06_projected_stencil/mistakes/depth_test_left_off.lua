-- hint: The caster's far side shows through its near side: the depth test that pass 2 switched off is still off. Enable it again in pass 3.
-- hint.ca: La part posterior de l'oclusor es veu per davant de l'anterior: el depth test que el pas 2 ha desactivat continua desactivat. Torna'l a activar al pas 3.
-- hint.es: La cara posterior del oclusor se ve por delante de la anterior: el test de profundidad que el paso 2 desactivó sigue desactivado. Actívalo de nuevo en el paso 3.
-- hint.fr: L'arrière de l'objet apparaît devant l'avant : le test de profondeur coupé dans la passe 2 l'est toujours. Réactive-le dans la passe 3.

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
    gl.Enable(gl.STENCIL_TEST)
    gl.StencilFunc(gl.ALWAYS, 1, 1)
    gl.StencilOp(gl.KEEP, gl.KEEP, gl.REPLACE)
    receiver:draw(r.phong, { view = view, projection = projection, light = light, ambient = darkness })
  end)

  pass("2. the projected caster clears it where the shadow falls", function()
    gl.Disable(gl.DEPTH_TEST)
    gl.ColorMask(false, false, false, false)
    gl.StencilFunc(gl.EQUAL, 1, 1)
    gl.StencilOp(gl.KEEP, gl.KEEP, gl.ZERO)
    local onto_plane = shadow.planar(receiver.plane, light)
    caster:draw(r.flat, { view = view, projection = projection, model = onto_plane * caster.model })
  end)

  pass("3. the dark part of the receiver", function()
    gl.DepthFunc(gl.LEQUAL)
    gl.ColorMask(true, true, true, true)
    gl.StencilFunc(gl.EQUAL, 0, 1)
    gl.StencilOp(gl.KEEP, gl.KEEP, gl.KEEP)
    receiver:draw(r.phong, { view = view, projection = projection, light = light, lit = 0, ambient = darkness })
  end)

  pass("4. the caster", function()
    gl.DepthFunc(gl.LESS)
    gl.Disable(gl.STENCIL_TEST)
    caster:draw(r.phong, { view = view, projection = projection, light = light, lit = 1, ambient = 0.25 })
  end)
end

return recipe
