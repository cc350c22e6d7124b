-- A wall across a plane: from 1 below it to 1 above.
return {
  title = "A wall that is sunk into a plane",
  camera = { eye = vec3(3, 6, 7), target = vec3(-0.5, 0, 0), fovy = 40, near = 1, far = 50 },
  objects = {
    { name = "plane", role = "receiver", mesh = mesh.plane(8, 6) },
    { name = "wall", role = "caster",
      mesh = mesh.new{ positions = { 0, -1, -1,  0, -1, 1,  0, 1, 1,  0, 1, -1 },
                       indices = { 0, 1, 2,  0, 2, 3 } } },
  },
}
