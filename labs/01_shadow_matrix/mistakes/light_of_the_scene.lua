-- hint: The shadows stay where they are when the light moves: the matrix takes the scene's own light. It must take the one that the function is given.
-- hint.ca: Les ombres no es mouen quan es mou la llum: la matriu fa servir la llum pròpia de l'escena. Ha de fer servir la que rep la funció.
-- hint.es: Las sombras no se mueven cuando se mueve la luz: la matriz usa la luz propia de la escena. Debe usar la que recibe la función.
-- hint.fr: Les ombres ne bougent pas quand la lumière bouge : la matrice prend la lumière propre à la scène. Elle doit prendre celle que la fonction reçoit.

local recipe = {
  title   = "Lab 01: the matrix of a projected shadow",
  lecture = "002_b957b372f85420d1: Hard shadows",
  scene   = "room",
  truth   = "hard on receivers",
  params  = { light = param.point(0.2, 2.1, 0.9), darkness = param.number(0.25, 0, 1) },
}

-- multShadowMat(): projects from the light onto the plane. Both are vec4s of the world's space.
local function shadow_matrix(plane, light)
  local a, b, c, d = plane.x, plane.y, plane.z, plane.w
  local x, y, z, w = light.x, light.y, light.z, light.w
  local dot = a * x + b * y + c * z + d * w
  return mat4(dot - x * a, -y * a, -z * a, -w * a,
              -x * b, dot - y * b, -z * b, -w * b,
              -x * c, -y * c, dot - z * c, -w * c,
              -x * d, -y * d, -z * d, dot - w * d)
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
                                model = shadow_matrix(flattening_plane, scene.lights[1]) * caster.model })
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
