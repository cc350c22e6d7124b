-- A teapot over a table-top: the projected shadow reaches past the edge of the table, so that a
-- shadow which is not clipped to it is seen at once.
return {
  title = "A teapot over a table-top",
  camera = { eye = vec3(0.35, 3.7, 5.9), target = vec3(-0.1, 0.1, -0.05),
             fovy = 40, near = 0.5, far = 50 },
  lights = { vec4(2, 4, 1, 1) },
  objects = {
    { name = "table-top", role = "receiver", mesh = mesh.plane(4, 3),
      color = vec3(0.80, 0.62, 0.40) },
    { name = "teapot", role = "caster", mesh = mesh.teapot(1, 12),
      model = mat4.translate(-0.6, 0.35, -0.1), color = vec3(0.30, 0.48, 0.78) },
  },
}
