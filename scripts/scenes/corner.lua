-- Two planes under one caster's shadow: a wall that faces the camera, so that depth hardly changes
-- across it, and a floor seen at a grazing angle, so that it changes fast.
return {
  title = "A torus before a wall",
  camera = { eye = vec3(0, 0.85, 6), target = vec3(0, 0.85, -2), fovy = 30, near = 3, far = 12 },
  lights = { vec4(1.6, 2.9, 3.2, 1) },
  objects = {
    { name = "floor", role = "receiver", mesh = mesh.plane(5, 8), color = vec3(0.80, 0.62, 0.40),
      model = mat4.translate(0, 0, 1.5) },
    { name = "wall", role = "receiver", mesh = mesh.plane(5, 3), color = vec3(0.70, 0.76, 0.80),
      model = mat4.translate(0, 1.5, -2.5) * mat4.rotate(90, 1, 0, 0) },
    { name = "torus", role = "caster", mesh = mesh.torus(0.5, 0.17), color = vec3(0.30, 0.48, 0.78),
      model = mat4.translate(0.35, 1.15, 0) * mat4.rotate(70, 1, 0, 0) },
  },
}
