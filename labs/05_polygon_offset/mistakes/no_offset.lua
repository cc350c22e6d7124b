-- hint: The shadow is ragged: it has the depth of the surface that it lies on, and rounding decides at each pixel which is in front (z-fighting). Draw it with gl.PolygonOffset(-1, -4), and enable POLYGON_OFFSET_FILL.
-- hint.ca: L'ombra surt esparracada: té la mateixa profunditat que la superfície on cau, i a cada píxel l'arrodoniment decideix quina és al davant (z-fighting). Dibuixa-la amb gl.PolygonOffset(-1, -4) i activa POLYGON_OFFSET_FILL.
-- hint.es: La sombra sale deshilachada: tiene la misma profundidad que la superficie en la que cae, y en cada píxel el redondeo decide cuál está delante (z-fighting). Dibújala con gl.PolygonOffset(-1, -4) y activa POLYGON_OFFSET_FILL.
-- hint.fr: L'ombre est déchiquetée : elle a la profondeur de la surface sur laquelle elle tombe, et l'arrondi décide à chaque pixel laquelle est devant (z-fighting). Dessine-la avec gl.PolygonOffset(-1, -4) et active POLYGON_OFFSET_FILL.

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
