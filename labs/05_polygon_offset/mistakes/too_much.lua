-- hint: The shadow lies over what is in front of it: an offset of -100 brings it much too near. It has to overcome rounding and no more: -1, -4.
-- hint.ca: L'ombra tapa el que té al davant: un offset de -100 l'acosta massa. Només ha de superar l'arrodoniment: -1, -4.
-- hint.es: La sombra tapa lo que tiene delante: un offset de -100 la acerca demasiado. Solo tiene que superar el redondeo: -1, -4.
-- hint.fr: L'ombre recouvre ce qui est devant elle : un décalage de -100 la rapproche beaucoup trop. Il doit seulement dépasser l'arrondi : -1, -4.

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
    gl.PolygonOffset(-100, -100)
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
