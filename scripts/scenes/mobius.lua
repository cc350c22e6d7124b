-- A Möbius strip: open, with one border, and no way to orient it, so that at one seam neighbours run
-- along their common edge in the same direction.
local quads, across, radius, half = 120, 6, 1, 0.42

-- The strip at angle u, v from the middle of it; after one turn v is exchanged for -v.
local function point(u, v)
  local r = radius + v * math.cos(u / 2)
  return vec3(r * math.cos(u), v * math.sin(u / 2), r * math.sin(u))
end

local function normal(u, v)
  local along, over = point(u + 1e-4, v) - point(u - 1e-4, v), point(u, 1) - point(u, 0)
  return along:cross(over):normalize()
end

local positions, normals, indices = {}, {}, {}
for i = 0, quads do
  local u = 2 * math.pi * i / quads
  for k = 0, across do
    local v = half * (2 * k / across - 1)
    -- The last row is the first, exchanged, bit for bit.
    positions[#positions + 1] = i < quads and point(u, v) or positions[across + 1 - k]
    normals[#normals + 1] = normal(u, v)
  end
end
for i = 0, quads - 1 do
  for k = 0, across - 1 do
    local a = i * (across + 1) + k
    local b, c, d = a + 1, a + across + 1, a + across + 2
    for _, corner in ipairs{ a, c, b, b, c, d } do indices[#indices + 1] = corner end
  end
end

return {
  title = "A Möbius strip",
  camera = { eye = vec3(0.4, 3.0, 4.6), target = vec3(-0.2, 0.55, -0.1), fovy = 38, near = 0.6, far = 40 },
  lights = { vec4(1.8, 4.4, 1.6, 1) },
  objects = {
    { name = "floor", role = "receiver", mesh = mesh.plane(8, 8), color = vec3(0.76, 0.72, 0.80) },
    { name = "strip", role = "caster", color = vec3(0.86, 0.60, 0.24),
      mesh = mesh.new{ positions = positions, normals = normals, indices = indices },
      model = mat4.translate(0, 1.05, 0) * mat4.rotate(28, 1, 0, 0) * mat4.rotate(35, 0, 1, 0) },
  },
}
