-- 300 boxes, each within the one before and turned a little further, all cut open by the near plane:
-- the eye is in 300 shadows at once, more than a stencil of 8 bits can count. Everything within the
-- outermost is in shadow.
local count, outer, inner = 300, 1, 0.1
local shrink = (inner / outer) ^ (1 / (count - 1))
-- A square fits into one that is turned by t if it is smaller by cos t + sin t.
local turn = 0.9 * math.deg(1 / shrink - 1)

local objects = {
  { name = "floor", role = "receiver", mesh = mesh.plane(8, 8), color = vec3(0.80, 0.76, 0.66) },
  { name = "wall", role = "receiver", mesh = mesh.plane(8, 5), color = vec3(0.70, 0.76, 0.80),
    model = mat4.translate(0, 2.5, -2.5) * mat4.rotate(90, 1, 0, 0) },
}
for i = 1, count do
  local size, t = 2 * outer * shrink ^ (i - 1), i / count
  objects[#objects + 1] = {
    name = "shell " .. i, role = "caster", mesh = mesh.box(size),
    color = vec3(0.45, 0.65, 1):lerp(vec3(1, 0.85, 0.35), t) * (i % 30 < 15 and 1 or 0.75),
    model = mat4.translate(0, 1.45, 0) * mat4.rotate(turn * (i - 1), 0, 0, 1),
  }
end

return {
  title = "300 nested shells, cut open",
  camera = { eye = vec3(0.7, 2.3, 4.6), target = vec3(-0.1, 1.4, 0), fovy = 33, near = 4.5, far = 30 },
  lights = { vec4(3.2, 4.4, 2.2, 1) },
  objects = objects,
}
