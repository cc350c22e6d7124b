-- hint: There is no shadow: a positive offset increases z, that is, it draws the shadow behind its surface. Toward the eye is negative.
-- hint.ca: No hi ha ombra: un offset positiu incrementa la z, és a dir, dibuixa l'ombra darrere de la seva superfície. Cap a l'observador és negatiu.
-- hint.es: No hay sombra: un offset positivo incrementa la z, es decir, dibuja la sombra detrás de su superficie. Hacia el observador es negativo.
-- hint.fr: Il n'y a pas d'ombre : un décalage positif augmente z, c'est-à-dire qu'il dessine l'ombre derrière sa surface. Vers l'œil, il est négatif.

local recipe = {
  title   = "Lab 05: a projected shadow without z-fighting",
  lecture = "000_178f3ee06912f876: Ombres per projecció (un pla), z-fighting",
  scene   = "corner",
  params  = { light = param.point(1.4, 1.1, 4.8), darkness = param.number(0.25, 0, 1) },
}

function recipe.setup(r)
  r.phong = shader.load "phong_shadow"    -- the uniform `shadow`: draw the shadow's one colour
end

function recipe.draw(r)
  local scene, light, darkness = r.scene, r.params.light, r.params.darkness
  local view, projection = scene.camera:view(), scene.camera:projection(r.width / r.height)

  gl.ClearColor(0.85, 0.88, 0.92, 1)
  gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
  gl.Enable(gl.DEPTH_TEST)

  pass("1. the receivers", function()
    scene.receiver:draw(r.phong, { view = view, projection = projection, light = light, ambient = darkness })
  end)

  pass("2. the casters as shadows", function()
    r.phong:set("shadow", true)
    gl.Enable(gl.POLYGON_OFFSET_FILL)
    gl.PolygonOffset(1, 4)
    for _, receiver in ipairs(scene.receivers) do
      local onto_plane = shadow.planar(receiver.plane, light)
      for _, caster in ipairs(scene.casters) do
        caster:draw(r.phong, { view = view, projection = projection, model = onto_plane * caster.model,
                               color = receiver.color, ambient = darkness })
      end
    end
  end)

  pass("3. the casters", function()
    r.phong:set("shadow", false)
    gl.Disable(gl.POLYGON_OFFSET_FILL)
    scene.caster:draw(r.phong, { view = view, projection = projection, light = light, ambient = 0.25 })
  end)
end

return recipe
