-- A teapot alone, as lectures on anything but shadows draw it.
return {
  title = "A teapot",
  camera = { eye = vec3(1.1, 1.5, 3.4), target = vec3(0.1, 0.48, 0), fovy = 36, near = 1, far = 10 },
  lights = { vec4(3, 4, 5, 1) },
  objects = {
    { name = "teapot", mesh = mesh.teapot(1, 10), color = vec3(0.30, 0.48, 0.78) },
  },
}
