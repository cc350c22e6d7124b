-- A ball under the light, a floor that reaches far outside of the light's map, and a ceiling behind
-- the light.
return {
  title = "A lamp between floor and ceiling",
  camera = { eye = vec3(0, 1.6, 9), target = vec3(0, 1.6, 0), fovy = 60, near = 1, far = 40 },
  lights = { vec4(0, 2, 0, 1) },
  objects = {
    { name = "floor", role = "receiver", mesh = mesh.plane(30, 16), color = vec3(0.8) },
    { name = "ceiling", role = "receiver", mesh = mesh.plane(30, 16), color = vec3(0.8),
      model = mat4.translate(0, 4, 0) * mat4.rotate(180, 1, 0, 0) },
    { name = "ball", role = "caster", mesh = mesh.sphere(0.4), color = vec3(0.8), model = mat4.translate(0, 1, 0) },
  },
}
