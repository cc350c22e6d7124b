-- hint: The shadows are hard: all the drawings that are averaged are the same. Move the light by another jitter for each.
-- hint.ca: Les ombres són dures: tots els dibuixos de la mitjana són iguals. Mou la llum amb un jitter diferent per a cadascun.
-- hint.es: Las sombras son duras: todos los dibujos de la media son iguales. Mueve la luz con un jitter distinto para cada uno.
-- hint.fr: Les ombres sont dures : tous les dessins de la moyenne sont les mêmes. Déplace la lumière d'un autre décalage pour chacun.

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
      local jittered = light
      gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
      hard_room.draw(r, jittered, r.params.darkness)
      gl.Accum(gl.ACCUM, 1 / numJitters)
    end)
  end

  pass("the average", function()
    gl.Accum(gl.RETURN, 1)
  end)
end

return recipe
