-- The projected shadow with a depth test: one shader draws casters and shadows, told by the uniform
-- `shadow`, and a polygon offset of -1, -1 pulls the shadow in front of the plane that it lies in.
-- Other objects may now hide it. It still leaves the table, since the plane has no end.
local recipe = {
  title   = "Projected shadow with polygon offset",
  lecture = "000_178f3ee06912f876: Ombres per projecció (un pla), amb shaders",
  scene   = "table",
  params  = {
    light  = param.point(2, 4, 1),
    factor = param.number(-1, -8, 8),
    units  = param.number(-1, -8, 8),
  },
  keys    = { o = "toggle units -1 0", p = "toggle factor -1 0" },
}

function recipe.setup(r)
  r.phong = shader.load "phong_shadow"
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

  -- The slide's modelMatrix is the shadow matrix alone, for a caster that is modelled in its place.
  pass("2. the casters as shadows, pulled toward the viewer", function()
    r.phong:set("shadow", true)
    gl.Enable(gl.POLYGON_OFFSET_FILL)
    gl.PolygonOffset(r.params.factor, r.params.units)
    gl.Enable(gl.CLIP_DISTANCE0)
    local onto_plane = shadow.planar(receiver.plane, light)
    local above = shadow.plane_toward(receiver.plane, light)
    for _, caster in ipairs(scene.casters) do
      caster:draw(r.phong, { view = view, projection = projection,
                             model = onto_plane * caster.model,
                             above = caster.model:transpose() * above,
                             color = receiver.color })
    end
    gl.Disable(gl.CLIP_DISTANCE0)
  end)

  -- Mesa's software renderer heeds a clip distance that is not enabled: one that cuts nothing.
  pass("3. the casters", function()
    r.phong:set("shadow", false)
    gl.Disable(gl.POLYGON_OFFSET_FILL)
    scene.caster:draw(r.phong, { view = view, projection = projection, light = light,
                                 above = vec4(0, 0, 0, 1) })
  end)
end

return recipe
