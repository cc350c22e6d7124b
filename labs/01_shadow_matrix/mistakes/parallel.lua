-- hint: All shadows have the size of their caster, as if the light were at infinity: the last row must be -w a, -w b, -w c, P·L - w d. It makes the w that grows smaller the nearer a point is to the light.
-- hint.ca: Totes les ombres tenen la mida del seu oclusor, com si la llum fos a l'infinit: l'última fila ha de ser -w a, -w b, -w c, P·L - w d. És la que fa que w es redueixi com més a prop de la llum és el punt.
-- hint.es: Todas las sombras tienen el tamaño de su oclusor, como si la luz estuviera en el infinito: la última fila debe ser -w a, -w b, -w c, P·L - w d. Es la que hace que w disminuya cuanto más cerca de la luz está el punto.
-- hint.fr: Toutes les ombres ont la taille de leur objet, comme si la lumière était à l'infini : la dernière ligne doit être -w a, -w b, -w c, P·L - w d. C'est elle qui rend w plus petit quand le point est plus près de la lumière.

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
  return mat4(dot - x * a, -y * a, -z * a, 0,
              -x * b, dot - y * b, -z * b, 0,
              -x * c, -y * c, dot - z * c, 0,
              -x * d, -y * d, -z * d, dot)
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
