-- Lab 05. A floor, a wall and a torus. Pass 2, their shadows, is yours: fill in what is marked TO DO, and
-- see to it that the shadow does not fight with the surface that it lies on. README.md has the theory.
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
    -- TO DO (1): tell the shader that it draws a shadow: r.phong:set(name, value).
    -- TO DO (2): an offset that draws the shadow a little nearer to the eye than it is.
    for _, receiver in ipairs(scene.receivers) do
      local onto_plane = shadow.planar(receiver.plane, light)
      for _, caster in ipairs(scene.casters) do
        -- TO DO (3): draw the caster with r.phong, flattened by onto_plane, in the receiver's colour,
        -- with ambient = darkness: the part of the colour that a shadow leaves.
      end
    end
  end)

  pass("3. the casters", function()
    -- TO DO (4): neither a shadow nor an offset any more.
    scene.caster:draw(r.phong, { view = view, projection = projection, light = light, ambient = 0.25 })
  end)
end

return recipe
