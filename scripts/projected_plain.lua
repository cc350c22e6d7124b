-- The oldest shadow: the caster once more, flattened onto the receiver's plane and black. What is
-- wrong with it can be seen: the plane has no end, so the shadow leaves the table and hangs in the
-- air; without a depth test it covers whatever was drawn before it; it is black, whatever the table's
-- own colour is; and a caster on the other side of the plane from the light throws one too
-- (--set light=2,-2,1). projected_stencil mends all four.
local recipe = {
  title   = "Projected shadow, plain",
  lecture = "000_178f3ee06912f876: Ombres per projecció (un pla)",
  scene   = "table",
  params  = {
    light      = param.point(2, 4, 1),
    depth_test = param.toggle(false),
  },
  keys    = { d = "toggle depth_test" },
}

function recipe.setup(r)
  r.phong = shader.load "phong"
  r.flat = shader.load "flat"
end

function recipe.draw(r)
  local scene, light = r.scene, r.params.light
  local view, projection = scene.camera:view(), scene.camera:projection(r.width / r.height)
  local receiver = scene.receivers[1]

  gl.ClearColor(0.85, 0.88, 0.92, 1)
  gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
  gl.Enable(gl.DEPTH_TEST)

  pass("1. the receiver", function()
    receiver:draw(r.phong, { view = view, projection = projection, light = light })
  end)

  -- With the depth test, shadow and receiver are at one depth and fight for each pixel: the recipe
  -- zfighting shows it.
  pass("2. the projected casters, black", function()
    if not r.params.depth_test then gl.Disable(gl.DEPTH_TEST) end
    local onto_plane = shadow.planar(receiver.plane, light)
    for _, caster in ipairs(scene.casters) do
      caster:draw(r.flat, { view = view, projection = projection,
                            model = onto_plane * caster.model, color = vec3(0) })
    end
  end)

  pass("3. the casters", function()
    gl.Enable(gl.DEPTH_TEST)
    scene.caster:draw(r.phong, { view = view, projection = projection, light = light })
  end)
end

return recipe
