-- A square plate one metre over a floor, under a light four metres up, parallel to both.
return {
  title = "A plate over a floor",
  camera = { eye = vec3(1.3, 6, 0.001), target = vec3(1.3, 0, 0), fovy = 8, near = 1, far = 20 },
  lights = { vec4(0, 4, 0, 1) },
  objects = {
    { name = "floor", role = "receiver", mesh = mesh.plane(8, 8), color = vec3(0.8) },
    { name = "plate", role = "caster", mesh = mesh.plane(2, 2), model = mat4.translate(0, 1, 0), color = vec3(0.6) },
  },
}
