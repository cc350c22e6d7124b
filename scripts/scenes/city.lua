-- A street between a hundred houses in ten rows, seen from its near end at a person's height to the
-- far one, 200 metres off, in a low sun: what no single map has texels enough for.
local objects = {
  { name = "ground", role = "receiver", mesh = mesh.plane(120, 240), color = vec3(0.60, 0.58, 0.54),
    model = mat4.translate(0, 0, -100) },
}
local walls = { vec3(0.80, 0.62, 0.46), vec3(0.72, 0.70, 0.66), vec3(0.66, 0.44, 0.36), vec3(0.86, 0.80, 0.66) }
local house = mesh.box(1, 1, 1)

-- Sizes by a recurrence with a period of 97: no two rows are alike.
local state = 11
local function pick(from, to)
  state = state * 31 % 97
  return from + (to - from) * state / 97
end

for row = 0, 9 do
  for _, side in ipairs { -1, 1 } do
    for k = 0, 4 do
      local width, height, depth = pick(5, 8), pick(3, 14) + 4 * (k % 2), pick(9, 15)
      local x, z = side * (8 + 10 * k), -10 - 20 * row
      objects[#objects + 1] = {
        name = "house " .. #objects, mesh = house, color = walls[#objects % 4 + 1],
        model = mat4.translate(x, height / 2, z) * mat4.scale(width, height, depth),
      }
    end
  end
end

return {
  title = "A street of a hundred houses",
  camera = { eye = vec3(1.5, 2.2, 6), target = vec3(-0.5, 1.6, -40), fovy = 50, near = 0.5, far = 250 },
  lights = { vec4(0.7, 0.75, 0.3, 0) },
  objects = objects,
}
