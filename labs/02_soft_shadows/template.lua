-- Lab 02. The room is drawn numJitters times, always the same, and the last drawing is what you see: hard
-- shadows. Make them soft in the three places marked TO DO; README.md has the theory.
local hard_room = require "parts.hard_room"

local recipe = {
  title   = "Lab 02: soft shadows by the accumulation buffer",
  lecture = "002_b957b372f85420d1: Soft shadows",
  scene   = "room",
  params  = {
    light      = param.point(0.2, 2.1, 0.9),
    numJitters = param.integer(8, 1, 256),
    radius     = param.number(0.25, 0, 1),    -- of the lamp, a sphere
    darkness   = param.number(0.25, 0, 1),
  },
}

function recipe.setup(r)
  hard_room.setup(r)
end

function recipe.draw(r)
  local light, numJitters = r.params.light, r.params.numJitters
  -- numJitters places in the lamp, as offsets from its centre.
  local jitters = shadow.samples({ center = vec3(0), radius = r.params.radius }, numJitters, "hammersley", 1)

  gl.ClearColor(0.10, 0.11, 0.14, 1)
  gl.Clear(gl.ACCUM_BUFFER_BIT)

  for i = 1, numJitters do
    pass("drawing " .. i .. " of " .. numJitters, function()
      -- TO DO (1): the light, moved by jitters[i].xyz. A light is a vec4 whose w says that it is a point.
      local jittered = light
      gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
      hard_room.draw(r, jittered, r.params.darkness)
      -- TO DO (2): add the frame to the accumulation buffer, with the weight that makes an average.
    end)
  end

  pass("the average", function()
    -- TO DO (3): bring the accumulation buffer's contents back into the frame.
  end)
end

return recipe
