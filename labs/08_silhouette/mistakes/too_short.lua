-- hint: The shadow ends in the air: the volume is half a metre long. A1 = L + (A - L) * infinity, and infinity must reach past everything that is seen.
-- hint.ca: L'ombra s'acaba a l'aire: el volum fa mig metre. A1 = L + (A - L) * infinit, i l'infinit ha d'arribar més enllà de tot el que es veu.
-- hint.es: La sombra se acaba en el aire: el volumen mide medio metro. A1 = L + (A - L) * infinito, y el infinito debe llegar más allá de todo lo que se ve.
-- hint.fr: L'ombre s'arrête en l'air : le volume fait un demi-mètre. A1 = L + (A - L) * infini, et l'infini doit dépasser tout ce qu'on voit.

local recipe = {
  title   = "Lab 08: the silhouette, and the volume that it throws",
  lecture = "004_502e9deeb91da7bb: Calcul des adjacences, visibilité des faces, dessin du shadow volume",
  scene   = "lamps",
  params  = { light = param.point(-1.6, 3.2, 0.9), darkness = param.number(0.6, 0, 1) },
}

local infinity = 100

-- Whether a face (its three corners, counter-clockwise from outside) sees the light.
local function faces_light(a, b, c, light)
  local normal = (b - a):cross(c - a)
  return normal:dot(light - a) > 0
end

-- The edges {from, to} between a face that sees the light and one that does not, in the order in which the lit
-- face has them. graph.triangles[i] holds three indices into graph.positions, graph.next[i] the faces across
-- the edges from the 1st to the 2nd of them, the 2nd to the 3rd, the 3rd to the 1st.
local function silhouette(graph, light)
  local lit, edges = {}, {}
  for i, triangle in ipairs(graph.triangles) do
    local a, b, c = graph.positions[triangle[1]], graph.positions[triangle[2]], graph.positions[triangle[3]]
    lit[i] = faces_light(a, b, c, light)
  end
  for i, triangle in ipairs(graph.triangles) do
    if lit[i] then
      for k = 1, 3 do
        if not lit[graph.next[i][k]] then
          edges[#edges + 1] = { graph.positions[triangle[k]], graph.positions[triangle[k % 3 + 1]] }
        end
      end
    end
  end
  return edges
end

-- The quads A, B, B1, A1 of the edges, as a mesh. A1 and B1 are A and B, seen from the light, far behind.
local function volume_mesh(edges, light)
  local positions, indices = {}, {}
  for _, edge in ipairs(edges) do
    local a, b = edge[1], edge[2]
    local a1, b1 = a + (a - light):normalize() / 2, b + (b - light):normalize() / 2
    local first = #positions
    for _, corner in ipairs{ a, b, b1, a1 } do positions[#positions + 1] = corner end
    for _, corner in ipairs{ 0, 2, 1, 0, 3, 2 } do indices[#indices + 1] = first + corner end
  end
  return #indices > 0 and mesh.new{ positions = positions, indices = indices } or nil
end

function recipe.setup(r)
  r.phong = shader.load "phong"
  r.flat = shader.load "flat"
  r.quad = mesh.quad()
  r.graphs = {}
  for k, caster in ipairs(r.scene.casters) do r.graphs[k] = shadow.adjacency(caster.mesh) end
end

function recipe.draw(r)
  local scene, camera, light = r.scene, r.scene.camera, r.params.light
  local view = camera:view()
  local projection = shadow.infinite_perspective(camera.fovy, r.width / r.height, camera.near)

  gl.ClearColor(0.85, 0.88, 0.92, 1)
  gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT)
  gl.Enable(gl.DEPTH_TEST)

  pass("1. the scene", function()
    scene:draw(r.phong, { view = view, projection = projection, light = light })
  end)

  pass("2. the volumes are counted", function()
    gl.ColorMask(false, false, false, false)
    gl.DepthMask(false)
    gl.Enable(gl.STENCIL_TEST)
    gl.StencilFunc(gl.ALWAYS, 1, 0xFFFFFFFF)
    gl.StencilOpSeparate(gl.FRONT, gl.KEEP, gl.KEEP, gl.INCR_WRAP)
    gl.StencilOpSeparate(gl.BACK, gl.KEEP, gl.KEEP, gl.DECR_WRAP)
    gl.Enable(gl.POLYGON_OFFSET_FILL)           -- the sides begin on the caster, not in front of it
    gl.PolygonOffset(1 / 256, 2)
    for k, caster in ipairs(scene.casters) do
      -- The graph is in the caster's own space; so is the light, then.
      local own_light = caster.model:inverse():transform_point(light.xyz)
      local volume = volume_mesh(silhouette(r.graphs[k], own_light), own_light)
      if volume then
        volume:draw(r.flat, { view = view, projection = projection, model = caster.model, color = vec3(0) })
      end
    end
    -- The sky is in no shadow: where nothing was drawn, the depth is still 1.
    gl.Disable(gl.POLYGON_OFFSET_FILL)
    gl.DepthRange(1, 1)
    gl.DepthFunc(gl.EQUAL)
    gl.StencilOp(gl.KEEP, gl.KEEP, gl.ZERO)
    r.quad:draw(r.flat, { color = vec3(0), alpha = 1 })
    gl.DepthRange(0, 1)
    gl.DepthFunc(gl.LESS)
  end)

  pass("3. a dark quad over all that is in a volume", function()
    gl.Disable(gl.DEPTH_TEST)
    gl.ColorMask(true, true, true, true)
    gl.Enable(gl.BLEND)
    gl.BlendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA)
    gl.StencilFunc(gl.NOTEQUAL, 0, 0xFFFFFFFF)
    gl.StencilOp(gl.KEEP, gl.KEEP, gl.KEEP)
    r.quad:draw(r.flat, { color = vec3(0), alpha = r.params.darkness })
  end)
end

return recipe
