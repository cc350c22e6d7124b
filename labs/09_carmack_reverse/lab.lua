-- Low suns from the right, so that the right-hand houses shadow the right-hand pavement, where the eye is.
local function low_sun() return { 1, random.number(0.35, 0.5), random.number(-0.2, 0.2) } end
-- Before a house's long side: houses stand every 20 metres from z = -10 on.
local function on_the_pavement(row, toward)
  local x, z = random.number(2.4, 2.8), -10 - 20 * row + random.number(-2, 2)
  local target = { random.number(-8, -4), random.number(0.8, 1.6), z - random.number(16, 30) }
  -- Away from the sun a ray stays in the shadow that it is in, as far as infinity.
  if toward == "down-sun" then target = { -7, random.number(-2, -1), z - random.number(0, 3) } end
  return { eye = { x, 1, z }, target = target, fovy = 50 }
end

return {
  title  = "Carmack's reverse: the eye in the shadow",
  points = 10,
  size   = { 256, 256 },
  scene  = "city",
  cases  = {
    { name = "the eye in a house's shadow", points = 2, set = { light = { -0.5, 0.55, -0.85 } }, compare = { color = true } },
    { name = "on the other side of the street", points = 3, set = { light = low_sun() }, camera = on_the_pavement(0, "down-sun"),
      compare = { color = true } },
    { name = "farther down the street", points = 3, hidden = true, camera = on_the_pavement(random.integer(1, 3)),
      set = { light = low_sun(), darkness = random.number(0.15, 0.4) }, compare = { color = true } },
    { name = "at the end of the street", points = 2, hidden = true,
      set = { light = { random.number(-0.75, -0.5), random.number(0.33, 0.48), -0.7 } }, compare = { color = true } },
  },
}
