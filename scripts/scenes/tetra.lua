-- A tetrahedron over a plane, all in round numbers. From the light (4, 5, 2) a point at height h
-- lands at L + (v - L) · 5 / (5 - h): the base, at height 1, by 5/4, the apex, at 2.5, by 2. So the
-- shadow on the plane y = 0 is the quadrilateral of these (x, z):
--
--   base (-1, 1, -1), (1, 1, -1), (0, 1, 1)  ->  (-2.25, -1.75), (0.25, -1.75), (-1, 0.75)
--   apex (0, 2.5, 0)                         ->  (-4, -2)
return {
  title = "A tetrahedron over a plane",
  camera = { eye = vec3(-0.5, 6.5, 8.5), target = vec3(-1, 0.2, -0.4),
             fovy = 42, near = 1, far = 50 },
  lights = { vec4(4, 5, 2, 1) },
  objects = {
    { name = "plane", role = "receiver", mesh = mesh.plane(8, 6), model = mat4.translate(-1, 0, 0),
      color = vec3(0.74, 0.78, 0.72) },
    { name = "tetrahedron", role = "caster", color = vec3(0.86, 0.42, 0.24),
      -- A position for each face: flat shading.
      mesh = (function()
        local a, b, c, d = vec3(-1, 1, -1), vec3(1, 1, -1), vec3(0, 1, 1), vec3(0, 2.5, 0)
        return mesh.new{ positions = { a, b, c,  a, d, b,  b, d, c,  c, d, a },
                         indices = { 0, 1, 2,  3, 4, 5,  6, 7, 8,  9, 10, 11 } }
      end)() },
  },
}
