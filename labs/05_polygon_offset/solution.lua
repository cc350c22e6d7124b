-- The shadow has the depth of the surface that it lies on, and which of the two wins at a pixel is a
-- matter of rounding. A polygon offset draws it a little nearer to the eye. The lecture's -1, -1 leaves holes
-- in the shadow on the wall: seen head on it has no slope, and rounding is more than one unit of depth.
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
    gl.PolygonOffset(-1, -4)
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
