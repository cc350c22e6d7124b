-- hint: The shadow on the wall has holes: -1, -1, the lecture's typical values, are one unit where rounding errs by more. On a wall that is seen head on the factor adds nothing, so give it more units: -1, -4.
-- hint.ca: L'ombra de la paret té forats: -1, -1, els valors típics de la classe, són una sola unitat on l'arrodoniment s'equivoca de més. En una paret vista de cara el factor no hi afegeix res; dona-li més unitats: -1, -4.
-- hint.es: La sombra de la pared tiene agujeros: -1, -1, los valores típicos de la clase, son una sola unidad donde el redondeo yerra en más. En una pared vista de frente el factor no añade nada; dale más unidades: -1, -4.
-- hint.fr: L'ombre sur le mur a des trous : -1, -1, les valeurs typiques du cours, font une seule unité là où l'arrondi se trompe davantage. Sur un mur vu de face le facteur n'ajoute rien ; donne-lui plus d'unités : -1, -4.

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
    gl.PolygonOffset(-1, -1)
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
