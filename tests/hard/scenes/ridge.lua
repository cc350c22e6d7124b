-- A ridge: of two planes that cast the one falls off from the other, by 40 degrees at x = 0. No light that
-- reaches both leaves a shadow.
return {
  title = "A ridge",
  camera = { eye = vec3(0, 6, 0.01), target = vec3(0), fovy = 30, near = 1, far = 20 },
  lights = { vec4(0, 1, 0, 0) },
  objects = {
    { name = "plane", mesh = mesh.plane(2, 2), color = vec3(0.8), model = mat4.translate(-1, 0, 0) },
    { name = "slope", mesh = mesh.plane(2, 2), color = vec3(0.6),
      model = mat4.rotate(-40, 0, 0, 1) * mat4.translate(1, 0, 0) },
  },
}
