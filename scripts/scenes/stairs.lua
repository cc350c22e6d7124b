-- A flight of stairs under a railing: a shadow that breaks at every edge of a step, and steps that
-- shadow each other. The stairs cast and receive; posts stand on the treads, the rail over them.
local cells = require "parts.cells"
local steps, width, tread, rise = 7, 3, 0.6, 0.32
local half = width / 2

local function post(step)
  local foot = vec3(half - 0.25, step * rise, -(step - 0.5) * tread)
  return { name = "post " .. step, role = "caster", color = vec3(0.34, 0.42, 0.56),
           mesh = mesh.box(0.07, 0.9, 0.07), model = mat4.translate(foot + vec3(0, 0.45, 0)) }
end

-- Cell j of the profile is step j: solid from the ground to its tread.
local depths, heights = {}, {}
for i = 0, steps do
  depths[i + 1] = (i - steps) * tread
  heights[i + 1] = i * rise
end
local flight = cells({ -half, half }, heights, depths,
                     function(_, height, depth) return height <= steps + 1 - depth end)

local objects = {
  { name = "floor", role = "receiver", mesh = mesh.plane(9, 9), color = vec3(0.72, 0.70, 0.66),
    model = mat4.translate(0, 0, -1) },
  { name = "stairs", role = "both", mesh = flight, color = vec3(0.82, 0.72, 0.58) },
}
for step = 1, steps do objects[#objects + 1] = post(step) end

-- As steep as the stairs, a little over the posts.
local slope = math.deg(math.atan(rise, tread))
local length = (steps - 1) * math.sqrt(rise * rise + tread * tread) + 0.5
local middle = vec3(half - 0.25, (steps + 1) / 2 * rise + 0.96, -steps / 2 * tread)
objects[#objects + 1] = {
  name = "rail", role = "caster", mesh = mesh.box(0.12, 0.08, length), color = vec3(0.34, 0.42, 0.56),
  model = mat4.translate(middle) * mat4.rotate(slope, 1, 0, 0),
}

return {
  title = "Stairs under a railing",
  camera = { eye = vec3(-4.6, 4.6, 4.4), target = vec3(0.1, 0.95, -1.9), fovy = 36, near = 0.8, far = 40 },
  lights = { vec4(4.2, 5.2, 1.6, 1) },
  objects = objects,
}
