-- The Cornell box with its two blocks, in metres (measurements of the real one, Cornell University
-- Program of Computer Graphics, rounded to the centimetre), and the light a hand below the ceiling.
local side = 5.5
local white = vec3(0.76, 0.75, 0.72)

local function wall(name, color, model)
  return { name = name, role = "receiver", color = color, mesh = mesh.plane(side, side), model = model }
end

return {
  title = "The Cornell box",
  camera = { eye = vec3(0, 2.75, 10.6), target = vec3(0, 2.7, 0), fovy = 38, near = 4, far = 20 },
  lights = { vec4(0, 5.2, 0, 1) },
  objects = {
    wall("floor", white, mat4.identity()),
    wall("ceiling", white, mat4.translate(0, side, 0) * mat4.rotate(180, 1, 0, 0)),
    wall("left wall", vec3(0.63, 0.06, 0.05),
         mat4.translate(-side / 2, side / 2, 0) * mat4.rotate(-90, 0, 0, 1)),
    wall("right wall", vec3(0.14, 0.45, 0.09),
         mat4.translate(side / 2, side / 2, 0) * mat4.rotate(90, 0, 0, 1)),
    wall("back wall", white, mat4.translate(0, side / 2, -side / 2) * mat4.rotate(90, 1, 0, 0)),
    { name = "tall block", role = "caster", mesh = mesh.box(1.65, 3.3, 1.65), color = white,
      model = mat4.translate(-0.92, 1.65, -0.76) * mat4.rotate(17, 0, 1, 0) },
    { name = "short block", role = "caster", mesh = mesh.box(1.65, 1.65, 1.65), color = white,
      model = mat4.translate(0.9, 0.825, 0.98) * mat4.rotate(-17, 0, 1, 0) },
  },
}
