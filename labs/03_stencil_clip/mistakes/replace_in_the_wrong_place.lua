-- hint: No shadow is drawn, since no receiver is marked: gl.StencilOp takes (stencil fails, depth fails, both pass). A receiver that is seen passes both tests, so REPLACE is the third.
-- hint.ca: No es dibuixa cap ombra, perquè cap receptor queda marcat: gl.StencilOp rep (falla l'stencil, falla la z, passen tots dos). Un receptor visible passa tots dos tests: REPLACE va en tercer lloc.
-- hint.es: No se dibuja ninguna sombra, porque ningún receptor queda marcado: gl.StencilOp recibe (falla el stencil, falla la profundidad, pasan ambos). Un receptor visible pasa ambos tests: REPLACE va en tercer lugar.
-- hint.fr: Aucune ombre n'est dessinée, car aucun récepteur n'est marqué : gl.StencilOp prend (échec du stencil, échec de la profondeur, réussite des deux). Un récepteur visible réussit les deux tests : REPLACE est le troisième.

local recipe = {
  title   = "Lab 03: a shadow that ends where its receiver does",
  lecture = "002_b957b372f85420d1: Shadow clipping with the stencil test",
  scene   = "corner",
  truth   = "hard on receivers",
  params  = { light = param.point(1.6, 2.9, 3.2), darkness = param.number(0.25, 0, 1) },
}

function recipe.setup(r)
  r.phong = shader.load "phong"
  r.planar = shader.load "planar"
end

function recipe.draw(r)
  local scene, light, darkness = r.scene, r.params.light, r.params.darkness
  local view, projection = scene.camera:view(), scene.camera:projection(r.width / r.height)

  gl.ClearColor(0.85, 0.88, 0.92, 1)
  gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
  gl.Enable(gl.DEPTH_TEST)

  for number, receiver in ipairs(scene.receivers) do
    pass(2 * number - 1 .. ". the " .. receiver.name, function()
      gl.Clear(gl.STENCIL_BUFFER_BIT)
      gl.Enable(gl.STENCIL_TEST)
      gl.StencilFunc(gl.ALWAYS, 1, 0xFFFFFFFF)
      gl.StencilOp(gl.KEEP, gl.REPLACE, gl.KEEP)
      receiver:draw(r.phong, { view = view, projection = projection, light = light, ambient = darkness })
    end)

    pass(2 * number .. ". its shadow", function()
      gl.StencilFunc(gl.EQUAL, 1, 0xFFFFFFFF)
      gl.Disable(gl.DEPTH_TEST)
      local onto_plane = shadow.planar(receiver.plane, light)
      for _, caster in ipairs(scene.casters) do
        caster:draw(r.planar, { view = view, projection = projection, model = onto_plane * caster.model,
                                color = receiver.color * darkness })
      end
      gl.Enable(gl.DEPTH_TEST)
      gl.Disable(gl.STENCIL_TEST)
    end)
  end

  pass("the casters", function()
    scene.caster:draw(r.phong, { view = view, projection = projection, light = light, ambient = 0.25 })
  end)
end

return recipe
