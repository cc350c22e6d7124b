-- hint: The far sides of the casters show through: the depth test is off for the shadow and stays off. Enable it again when the shadow is drawn.
-- hint.ca: Es veu la part posterior dels oclusors: el depth test es desactiva per a l'ombra i es queda desactivat. Torna'l a activar quan l'ombra estigui dibuixada.
-- hint.es: Se ve la parte posterior de los oclusores: el test de profundidad se desactiva para la sombra y se queda desactivado. Actívalo de nuevo cuando la sombra esté dibujada.
-- hint.fr: On voit l'arrière des objets : le test de profondeur est coupé pour l'ombre et le reste. Réactive-le une fois l'ombre dessinée.

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
      gl.StencilOp(gl.KEEP, gl.KEEP, gl.REPLACE)
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
      gl.Disable(gl.STENCIL_TEST)
    end)
  end

  pass("the casters", function()
    scene.caster:draw(r.phong, { view = view, projection = projection, light = light, ambient = 0.25 })
  end)
end

return recipe
