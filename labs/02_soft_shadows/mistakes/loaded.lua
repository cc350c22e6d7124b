-- hint: The picture is dark and its shadows are hard: LOAD forgets what was there, so only the last drawing is left, with its small weight. Use ACCUM, which adds.
-- hint.ca: La imatge és fosca i les ombres són dures: LOAD oblida el que hi havia, i només queda l'últim dibuix, amb el seu pes petit. Fes servir ACCUM, que suma.
-- hint.es: La imagen es oscura y las sombras son duras: LOAD olvida lo que había, y solo queda el último dibujo, con su peso pequeño. Usa ACCUM, que suma.
-- hint.fr: L'image est sombre et les ombres sont dures : LOAD oublie ce qu'il y avait, et il ne reste que le dernier dessin, avec son petit poids. Prends ACCUM, qui ajoute.

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
      gl.Accum(gl.LOAD, 1 / numJitters)
    end)
  end

  pass("the average", function()
    gl.Accum(gl.RETURN, 1)
  end)
end

return recipe
