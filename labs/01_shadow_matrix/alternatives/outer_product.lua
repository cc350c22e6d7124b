-- Right in another way: by columns, each the light times one of the plane's coefficients.
local recipe = {
  title   = "Lab 01: the matrix of a projected shadow",
  lecture = "002_b957b372f85420d1: Hard shadows",
  scene   = "room",
  truth   = "hard on receivers",
  params  = { light = param.point(0.2, 2.1, 0.9), darkness = param.number(0.25, 0, 1) },
}

-- multShadowMat(): projects from the light onto the plane. Both are vec4s of the world's space.
local function shadow_matrix(plane, light)
  return plane:dot(light) * mat4.identity() - mat4(light * plane.x, light * plane.y, light * plane.z, light * plane.w)
end

function recipe.setup(r)
  r.gouraud = shader.load "gouraud"
  r.planar = shader.load "planar"
  r.orb = shader.load "orb"
  r.sphere = mesh.sphere(0.04, 24, 12)
end

function recipe.draw(r)
  local scene, light, darkness = r.scene, r.params.light, r.params.darkness
  local view, projection = scene.camera:view(), scene.camera:projection(r.width / r.height)

  gl.ClearColor(0.10, 0.11, 0.14, 1)
  gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
  gl.Enable(gl.DEPTH_TEST)

  pass("the light", function()
    r.sphere:draw(r.orb, { view = view, projection = projection, color = vec3(1, 0.95, 0.7),
                           model = mat4.translate(light.xyz) })
  end)

  for _, wall in ipairs(scene.receivers) do
    -- The stencil keeps the shadow on its wall: that is lab 03.
    pass("the " .. wall.name, function()
      gl.Clear(gl.STENCIL_BUFFER_BIT)
      gl.Enable(gl.STENCIL_TEST)
      gl.StencilFunc(gl.ALWAYS, 1, 0xFF)
      gl.StencilOp(gl.KEEP, gl.KEEP, gl.REPLACE)
      wall:draw(r.gouraud, { view = view, projection = projection, light = light, ambient = darkness })
    end)

    pass("its shadows", function()
      gl.StencilFunc(gl.EQUAL, 1, 0xFF)
      gl.Disable(gl.DEPTH_TEST)
      local flattening_plane = wall.plane
      for _, caster in ipairs(scene.casters) do
        caster:draw(r.planar, { view = view, projection = projection, color = wall.color * darkness,
                                model = shadow_matrix(flattening_plane, light) * caster.model })
      end
      gl.Enable(gl.DEPTH_TEST)
      gl.Disable(gl.STENCIL_TEST)
    end)
  end

  pass("the teapot and the torus", function()
    scene.caster:draw(r.gouraud, { view = view, projection = projection, light = light, ambient = darkness })
  end)
end

return recipe
