-- Two lamps and the sky: three shadows of each caster, which overlap each other and the other's.
return {
  title = "A box and a torus under two lamps and the sky",
  camera = { eye = vec3(0.3, 3.6, 6.4), target = vec3(0, 0.35, 0), fovy = 38, near = 0.5, far = 50 },
  lights = { vec4(-2.6, 3.4, 1.2, 1), vec4(2.4, 2.9, 0.6, 1), vec4(0.2, 1, -0.5, 0) },
  objects = {
    { name = "table-top", role = "receiver", mesh = mesh.plane(5, 4), color = vec3(0.80, 0.74, 0.62) },
    { name = "box", role = "caster", mesh = mesh.box(0.8, 0.8, 0.8), color = vec3(0.86, 0.45, 0.30),
      model = mat4.translate(-0.75, 0.4, 0.2) * mat4.rotate(30, 0, 1, 0) },
    { name = "torus", role = "caster", mesh = mesh.torus(0.5, 0.17), color = vec3(0.34, 0.52, 0.78),
      model = mat4.translate(0.8, 0.75, -0.1) * mat4.rotate(60, 1, 0, 0) },
  },
}
