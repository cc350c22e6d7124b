-- A teapot over a table-top: the projected shadow reaches past the edge of the table, so that a
-- shadow which is not clipped to it is seen at once.
return {
  title = "A teapot over a table-top",
  camera = { eye = vec3(0, 3.4, 5.4), target = vec3(0.2, 0.3, 0), fovy = 40, near = 0.5, far = 50 },
  lights = { vec4(2, 4, 1, 1) },
  objects = {
    { name = "table-top", role = "receiver", mesh = mesh.plane(4, 3),
      color = vec3(0.76, 0.62, 0.44) },
    { name = "teapot", role = "caster", mesh = mesh.teapot(1, 12),
      model = mat4.translate(-0.6, 0.35, -0.1), color = vec3(0.42, 0.55, 0.78) },
  },
}
