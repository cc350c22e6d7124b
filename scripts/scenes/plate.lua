-- A plate parallel to the floor under a light: its shadow has straight edges whose penumbra is a ramp of
-- known width, and corners where two ramps multiply.
return {
  title = "A plate over a floor",
  camera = { eye = vec3(0, 3.0, 3.4), target = vec3(0, 0.25, 0.1), fovy = 42, near = 0.5, far = 20 },
  lights = { vec4(0.2, 3, 0.1, 1) },
  objects = {
    { name = "floor", role = "receiver", mesh = mesh.plane(5, 4), color = vec3(0.80, 0.74, 0.62) },
    { name = "plate", role = "caster", mesh = mesh.plane(1.2, 0.9), color = vec3(0.34, 0.48, 0.70),
      model = mat4.translate(0, 1, 0) },
  },
}
