-- Blades of grass around a stone: thousands of slender open triangles, each shadowing its neighbours
-- and itself. Places and shapes are a fixed sequence, the same on every machine.
local blades, joints = 900, 3

-- Numbers in [0, 1) that fill it evenly, one sequence for each step: i · step mod 1.
local function spread(i, step) return i * step % 1 end
local first, second, third = 0.7548776662466927, 0.5698402909980532, 0.6180339887498949

local positions, indices = {}, {}
local function blade(root, lean, height, width)
  local across = vec3(-lean.z, 0, lean.x) * width
  local base = #positions
  for k = 0, joints - 1 do
    local t = k / joints
    local middle = root + vec3(0, height * t, 0) + lean * (height * 0.55 * t * t)
    positions[#positions + 1] = middle - across * (1 - t * t)
    positions[#positions + 1] = middle + across * (1 - t * t)
  end
  positions[#positions + 1] = root + vec3(0, height * 0.95, 0) + lean * (height * 0.6)
  for k = 0, joints - 2 do
    local a = base + 2 * k
    for _, corner in ipairs{ a, a + 1, a + 2, a + 2, a + 1, a + 3 } do indices[#indices + 1] = corner end
  end
  for _, corner in ipairs{ 2, 1, 0 } do indices[#indices + 1] = #positions - 1 - corner end
end

for i = 1, blades do
  -- A little under the ground: depth cannot tell a root that ends in it from the ground itself.
  local root = vec3(5 * spread(i, first) - 2.5, -0.01, 4 * spread(i, second) - 2)
  if root:distance(vec3(0.5, root.y, 0.2)) > 0.62 then
    local angle = 2 * math.pi * spread(i * i % 7919, third)
    blade(root, vec3(math.cos(angle), 0, math.sin(angle)), 0.35 + 0.5 * spread(i * 31, third),
          0.018 + 0.014 * spread(i * 17, first))
  end
end

return {
  title = "Grass around a stone",
  camera = { eye = vec3(-0.3, 2.0, 4.4), target = vec3(0.05, 0.25, -0.1), fovy = 40, near = 0.5, far = 40 },
  lights = { vec4(3.2, 3.6, 1.4, 1) },
  objects = {
    { name = "ground", role = "receiver", mesh = mesh.plane(7, 6), color = vec3(0.60, 0.52, 0.38) },
    { name = "stone", role = "caster", mesh = mesh.sphere(0.5, 14, 8), color = vec3(0.66, 0.66, 0.68),
      model = mat4.translate(0.5, 0.3, 0.2) * mat4.scale(1, 0.7, 0.85) },
    { name = "grass", role = "caster", mesh = mesh.new{ positions = positions, indices = indices },
      color = vec3(0.36, 0.60, 0.24) },
  },
}
