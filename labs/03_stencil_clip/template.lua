-- Lab 03. Every receiver has its shadow, but the shadow does not know where the receiver ends. Fill in
-- the places marked TO DO; README.md has the steps.
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
      -- TO DO: clear the stencil and switch its test on. Every fragment is accepted and has 1 to
      -- store; it is stored where the fragment passes the stencil test and the depth test.
      receiver:draw(r.phong, { view = view, projection = projection, light = light, ambient = darkness })
    end)

    pass(2 * number .. ". its shadow", function()
      -- TO DO: accept a fragment only where the stencil is 1.
      gl.Disable(gl.DEPTH_TEST)
      local onto_plane = shadow.planar(receiver.plane, light)
      for _, caster in ipairs(scene.casters) do
        caster:draw(r.planar, { view = view, projection = projection, model = onto_plane * caster.model,
                                color = receiver.color * darkness })
      end
      gl.Enable(gl.DEPTH_TEST)
      -- TO DO: switch the stencil test off again.
    end)
  end

  pass("the casters", function()
    scene.caster:draw(r.phong, { view = view, projection = projection, light = light, ambient = 0.25 })
  end)
end

return recipe
