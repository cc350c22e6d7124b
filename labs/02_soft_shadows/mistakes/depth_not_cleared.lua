-- hint: The penumbra is too dark: depth is not cleared between the drawings, so the walls fail their own old depth and all shadows pile up. Clear colour and depth before each drawing.
-- hint.ca: La penombra és massa fosca: la profunditat no s'esborra entre dibuixos, de manera que les parets no passen el test contra la seva pròpia z i les ombres s'apilen. Esborra color i profunditat abans de cada dibuix.
-- hint.es: La penumbra es demasiado oscura: la profundidad no se borra entre dibujos, así que las paredes no pasan el test contra su propia profundidad y las sombras se apilan. Borra color y profundidad antes de cada dibujo.
-- hint.fr: La pénombre est trop sombre : la profondeur n'est pas effacée entre les dessins, les murs échouent donc contre leur propre profondeur et toutes les ombres s'empilent. Efface couleur et profondeur avant chaque dessin.

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
      if i == 1 then gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT) end
      hard_room.draw(r, jittered, r.params.darkness)
      gl.Accum(gl.ACCUM, 1 / numJitters)
    end)
  end

  pass("the average", function()
    gl.Accum(gl.RETURN, 1)
  end)
end

return recipe
