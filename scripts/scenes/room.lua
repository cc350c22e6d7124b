-- A room of five walls, each a receiver with its own plane that faces inward, open toward the
-- camera; a teapot and a torus in it and the light among them. The walls are fine enough for lighting
-- at their vertices.
local cells = 24
local width, height, depth = 4, 3, 4
local white = vec3(0.82, 0.80, 0.76)

local function wall(name, color, across, up, model)
  return { name = name, role = "receiver", color = color,
           mesh = mesh.plane(across, up, cells, cells), model = model }
end

return {
  title = "A room with a teapot and a torus",
  camera = { eye = vec3(0, 1.55, 7.2), target = vec3(0, 1.45, 0), fovy = 34, near = 1, far = 20 },
  lights = { vec4(0.2, 2.1, 0.9, 1) },
  objects = {
    wall("floor", white, width, depth, mat4.identity()),
    wall("ceiling", white, width, depth, mat4.translate(0, height, 0) * mat4.rotate(180, 1, 0, 0)),
    wall("left wall", vec3(0.78, 0.34, 0.28), height, depth,
         mat4.translate(-width / 2, height / 2, 0) * mat4.rotate(-90, 0, 0, 1)),
    wall("right wall", vec3(0.32, 0.58, 0.36), height, depth,
         mat4.translate(width / 2, height / 2, 0) * mat4.rotate(90, 0, 0, 1)),
    wall("back wall", white, width, height,
         mat4.translate(0, height / 2, -depth / 2) * mat4.rotate(90, 1, 0, 0)),
    { name = "teapot", role = "caster", mesh = mesh.teapot(0.75, 10), color = vec3(0.36, 0.52, 0.80),
      model = mat4.translate(-0.75, 0.45, -0.35) * mat4.rotate(25, 0, 1, 0) },
    { name = "torus", role = "caster", mesh = mesh.torus(0.42, 0.13), color = vec3(0.90, 0.72, 0.30),
      model = mat4.translate(0.95, 1.05, -0.1) * mat4.rotate(35, 0, 0, 1) * mat4.rotate(60, 1, 0, 0) },
  },
}
