-- A comb over a floor: a closed caster that is not convex, with shadows and gaps of a few pixels. Seen
-- along its teeth a light's ray goes through one after the other.
local cells = require "parts.cells"
local teeth, tooth, gap = 22, 0.08, 0.1

local xs = {}
for i = 0, teeth - 1 do
  xs[#xs + 1] = i * (tooth + gap)
  xs[#xs + 1] = i * (tooth + gap) + tooth
end
local length = xs[#xs]
-- Odd columns are teeth; the upper row is the back that holds them.
local comb = cells(xs, { 0, 1, 1.35 }, { -0.06, 0.06 },
                   function(column, row) return column % 2 == 1 or row == 2 end)

return {
  title = "A comb",
  camera = { eye = vec3(2.2, 3.6, 5.0), target = vec3(-0.15, 0.3, 0.55), fovy = 42, near = 0.6, far = 40 },
  lights = { vec4(2.1, 3.7, -2.2, 1) },
  objects = {
    { name = "floor", role = "receiver", mesh = mesh.plane(9, 9), color = vec3(0.78, 0.80, 0.74) },
    { name = "comb", role = "caster", mesh = comb, color = vec3(0.62, 0.30, 0.22),
      model = mat4.translate(0, 0.3, 0) * mat4.rotate(-14, 0, 1, 0) * mat4.translate(-length / 2, 0, 0) },
  },
}
