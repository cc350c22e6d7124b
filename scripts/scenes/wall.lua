-- An upright sheet on a floor, higher than the light: the shadow of its edge begins at the floor and
-- runs along z = 0 → -∞ at x = 0, with a penumbra that widens in proportion to the way from there.
return {
  title = "A wall",
  camera = { eye = vec3(1.2, 6, -2), target = vec3(0.4, 0, -2), up = vec3(0, 0, -1), fovy = 48, near = 1, far = 20 },
  lights = { vec4(0, 1.5, 2, 1) },
  objects = {
    { name = "floor", role = "receiver", mesh = mesh.plane(12, 12), color = vec3(0.80, 0.74, 0.62) },
    { name = "wall", role = "caster", mesh = mesh.plane(3, 4), color = vec3(0.34, 0.42, 0.56),
      model = mat4.translate(-1.5, 2, 0) * mat4.rotate(90, 1, 0, 0) },
  },
}
