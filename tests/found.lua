-- Worlds that the search for departures found (`shadowlab stress --search`), as it prints them:
--
--   { unit = 1, offset = vec3(0), light = vec4(2, 4, 1, 1), size = { 64, 64 },
--     camera = { eye = , target = , fovy = , near = , far = },
--     { mesh.box(1), "none", place, axis, degrees, scale }, … }
--
-- A floor of 12 by 12 and casters, all of it times `unit` and moved by `offset` in such units. The second
-- of a caster is how its mesh is broken: measure/trial_caster.h says what each word is.
local given = require "given"

local found = {}

function found.broken(one, damage)
  if damage == "none" then return one end
  local positions, indices = {}, {}
  for i = 0, one.vertices - 1 do positions[i + 1] = one:position(i) end
  local function add(...)
    for _, corner in ipairs{ ... } do indices[#indices + 1] = corner end
  end
  local function place(p)
    positions[#positions + 1] = p
    return #positions - 1
  end
  for t = 0, one.triangles - 1 do
    local a, b, c = one:triangle(t)
    local p, q, r = one:position(a), one:position(b), one:position(c)
    if damage == "opened" and t % 3 == 2 then goto next end
    if damage == "split" and t % 2 == 0 then
      local middle = place((p + q) / 2)
      add(a, middle, c,  middle, b, c)
      goto next
    end
    if damage == "reversed" or (damage == "mixed" and t % 2 == 1) then add(b, a, c) else add(a, b, c) end
    if damage == "twice" then add(a, b, c) end
    if damage == "finned" and t % 3 == 0 then add(b, a, place(p + q - r)) end
    if damage == "needles" then add(a, place((p + q) / 2), b,  c, c, a) end
    ::next::
  end
  return mesh.new{ positions = positions, indices = indices }
end

-- The world for given.draw, and its light.
function found.world(trial)
  local unit, offset = trial.unit or 1, trial.offset or vec3(0)
  local function placed(p) return (offset + p) * unit end
  local world = mat4.scale(unit, unit, unit) * mat4.translate(offset.x, offset.y, offset.z)
  local floor = given.floor()
  floor.model = world
  local objects = { floor }
  for i, caster in ipairs(trial) do
    local shape, damage, place, axis, degrees, scale = table.unpack(caster)
    objects[#objects + 1] = given.caster("caster " .. i, found.broken(shape, damage),
      world * mat4.translate(place.x, place.y, place.z) * mat4.rotate(degrees, axis.x, axis.y, axis.z)
            * mat4.scale(scale.x, scale.y, scale.z))
  end
  local camera, light = trial.camera, trial.light
  return given.world_of(objects, { eye = placed(camera.eye), target = placed(camera.target), fovy = camera.fovy,
                                   near = camera.near * unit, far = camera.far * unit }),
         light.w == 0 and light or vec4(placed(light.xyz), 1)
end

-- Calls use(world, light) with pictures of the trial's size, which is a square's.
function found.at_its_size(trial, use)
  local size = given.size
  given.size = trial.size[1]
  local fine, problem = pcall(use, found.world(trial))
  given.size = size
  if not fine then error(problem, 0) end
end

return found
