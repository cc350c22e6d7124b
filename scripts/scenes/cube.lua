-- A cube between the world's origin and the plane y = -1.5, and in front of the plane z = 0: something
-- to project from anywhere.
return {
  title = "A cube beside the axes",
  camera = { eye = vec3(3.2, 1.9, 6.2), target = vec3(0.3, -0.35, 0.3),
             fovy = 37, near = 0.5, far = 50 },
  lights = { vec4(1.25, 1.5625, 0.625, 1) },
  objects = {
    { name = "cube", role = "caster", mesh = mesh.box(0.5, 0.5, 0.5), color = vec3(0.90, 0.62, 0.28),
      model = mat4.translate(0.3, -0.95, 0.75) * mat4.rotate(20, 0, 1, 0) },
  },
}
