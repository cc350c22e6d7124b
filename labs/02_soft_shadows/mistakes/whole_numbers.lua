-- hint: The picture is black: 1 // numJitters is a division of whole numbers, and that is 0. Write 1 / numJitters.
-- hint.ca: La imatge és negra: 1 // numJitters és una divisió entera, i dona 0. Escriu 1 / numJitters.
-- hint.es: La imagen es negra: 1 // numJitters es una división entera, y da 0. Escribe 1 / numJitters.
-- hint.fr: L'image est noire : 1 // numJitters est une division entière, et elle donne 0. Écris 1 / numJitters.

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
      local jittered = light + vec4(jitters[i].xyz, 0)
      gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
      hard_room.draw(r, jittered, r.params.darkness)
      gl.Accum(gl.ACCUM, 1 // numJitters)
    end)
  end

  pass("the average", function()
    gl.Accum(gl.RETURN, 1)
  end)
end

return recipe
