-- One plane that casts, seen from above: all of it is lit, by any light over it.
return {
  title = "A plane",
  camera = { eye = vec3(0, 6, 0.01), target = vec3(0), fovy = 30, near = 1, far = 20 },
  lights = { vec4(0, 1, 0, 0) },
  objects = { { name = "plane", mesh = mesh.plane(2, 2), color = vec3(0.8),
                model = mat4.rotate(25, 0, 0, 1) * mat4.rotate(-20, 1, 0, 0) } },
}
