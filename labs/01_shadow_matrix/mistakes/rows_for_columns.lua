-- hint: The matrix is transposed: mat4 takes its elements column by column, as GL stores them, and these are rows. The element in row i and column j of L Pᵀ is L[i] P[j].
-- hint.ca: La matriu està transposada: mat4 rep els elements columna a columna, tal com els desa GL, i aquests són files. L'element de la fila i i la columna j de L Pᵀ és L[i] P[j].
-- hint.es: La matriz está transpuesta: mat4 recibe los elementos columna a columna, tal como los guarda GL, y estos son filas. El elemento de la fila i y la columna j de L Pᵀ es L[i] P[j].
-- hint.fr: La matrice est transposée : mat4 prend ses éléments colonne par colonne, comme GL les range, et ceux-ci sont des lignes. L'élément de la ligne i et de la colonne j de L Pᵀ est L[i] P[j].

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
  return mat4(dot - x * a, -x * b, -x * c, -x * d,
              -y * a, dot - y * b, -y * c, -y * d,
              -z * a, -z * b, dot - z * c, -z * d,
              -w * a, -w * b, -w * c, dot - w * d)
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
