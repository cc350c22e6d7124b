-- What both ways to draw the lab's room share: its walls in quads, and its casters turned.
local lamp = require "parts.lamp"

local lab_room = {}

-- A wall's rectangle in n by n quads, in its own plane y = 0.
function lab_room.wall_mesh(r, wall, n)
  local key = wall.name .. " " .. n
  r.wall_meshes = r.wall_meshes or {}
  if not r.wall_meshes[key] then
    local size = wall.mesh.high - wall.mesh.low
    r.wall_meshes[key] = mesh.plane(size.x, size.z, n, n)
  end
  return r.wall_meshes[key]
end

-- The pixels that a wall is within, as gl.Scissor takes them: those between its corners, or all of the
-- picture where one is not before the camera.
function lab_room.pixels(r, wall, seen)
  local low, high = vec2(r.width, r.height), vec2(0, 0)
  local to_clip = seen.projection * seen.view * wall.model
  for _, x in ipairs{ wall.mesh.low.x, wall.mesh.high.x } do
    for _, z in ipairs{ wall.mesh.low.z, wall.mesh.high.z } do
      local p = to_clip * vec4(x, 0, z, 1)
      if p.w < r.scene.camera.near then return 0, 0, r.width, r.height end
      local pixel = (p.xy / p.w + 1) / 2 * vec2(r.width, r.height)
      low, high = low:min(pixel), high:max(pixel)
    end
  end
  low, high = low:max(vec2(0, 0)), high:min(vec2(r.width, r.height))
  local x, y = math.floor(low.x), math.floor(low.y)
  return x, y, math.max(0, math.ceil(high.x) - x), math.max(0, math.ceil(high.y) - y)
end

-- All walls, or the floor alone.
function lab_room.walls(r)
  local shown = {}
  for _, wall in ipairs(r.scene.receivers) do
    if r.params.walls or wall.name == "floor" then shown[#shown + 1] = wall end
  end
  return shown
end

function lab_room.models(r)
  local turn = mat4.rotate(r.params.turn, 0, 1, 0)
  local models = {}
  for i, caster in ipairs(r.scene.casters) do models[i] = caster.model * turn end
  return models
end

-- The light as one sees it: larger without walls.
lab_room.orb_color = vec3(1, 0.95, 0.7)
function lab_room.orb_model(r, light)
  return mat4.translate(light.xyz) * mat4.scale(r.params.walls and 0.04 or 0.2)
end

-- Where the light is, one point after the other.
function lab_room.points(r)
  local params = r.params
  if not params.soft then return { params.light } end
  return shadow.samples(lamp(params.light, params.shape, params.radius), params.jitters, params.pattern, params.seed)
end

return lab_room
