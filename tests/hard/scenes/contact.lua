-- A wall that stands on a floor, both casting: every lit surface can shadow itself. The wall's foot is
-- the line x = 0, its sides are at 0 and -0.1.
return {
  title = "A wall on a floor",
  camera = { eye = vec3(0.4, 9, 0.01), target = vec3(0.4, 0, 0), fovy = 20, near = 1, far = 20 },
  lights = { vec4(-1, 1, 0, 0) },
  objects = {
    { name = "floor", mesh = mesh.plane(4, 4), color = vec3(0.8) },
    { name = "wall", mesh = mesh.box(0.1, 1, 3), color = vec3(0.6), model = mat4.translate(-0.05, 0.5, 0) },
  },
}
