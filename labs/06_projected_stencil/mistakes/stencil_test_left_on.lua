-- hint: The caster is missing wherever it covers the lit receiver: the stencil test still asks for 0. Disable it before pass 4.
-- hint.ca: Falta l'oclusor allà on tapa el receptor il·luminat: el test d'stencil encara demana 0. Desactiva'l abans del pas 4.
-- hint.es: Falta el oclusor allí donde tapa el receptor iluminado: el test de stencil todavía pide 0. Desactívalo antes del paso 4.
-- hint.fr: L'objet manque là où il couvre le récepteur éclairé : le test de stencil exige encore 0. Désactive-le avant la passe 4.

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
    gl.Enable(gl.DEPTH_TEST)
    gl.DepthFunc(gl.LEQUAL)
    gl.ColorMask(true, true, true, true)
    gl.StencilFunc(gl.EQUAL, 0, 1)
    gl.StencilOp(gl.KEEP, gl.KEEP, gl.KEEP)
    receiver:draw(r.phong, { view = view, projection = projection, light = light, lit = 0, ambient = darkness })
  end)

  pass("4. the caster", function()
    gl.DepthFunc(gl.LESS)
    caster:draw(r.phong, { view = view, projection = projection, light = light, lit = 1, ambient = 0.25 })
  end)
end

return recipe
