-- hint: The light wanders off: each jitter is added to the place where the last one left it. Each must start from the lamp's centre.
-- hint.ca: La llum es va allunyant: cada jitter se suma al lloc on l'havia deixat l'anterior. Cadascun ha de partir del centre del llum.
-- hint.es: La luz se va alejando: cada jitter se suma al lugar donde la dejó el anterior. Cada uno debe partir del centro de la lámpara.
-- hint.fr: La lumière s'éloigne : chaque décalage s'ajoute à l'endroit où le précédent l'a laissée. Chacun doit partir du centre de la lampe.

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
      light = light + vec4(jitters[i].xyz, 0)
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
