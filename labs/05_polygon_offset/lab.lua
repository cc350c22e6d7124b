-- From above, the torus shadows the floor alone; from the front, the wall alone. In the corner between them
-- the shadows of both planes come within an offset of each other, and who wins is nobody's mistake.
local function from_above() return random.point({ -1.2, 5, 0 }, { 1.2, 6.5, 1 }) end
local function from_the_front() return random.point({ 0.9, 0.95, 4.5 }, { 1.8, 1.15, 5.5 }) end

return {
  title  = "A projected shadow without z-fighting",
  points = 10,
  size   = { 256, 256 },
  scene  = "corner",
  cases  = {
    { name = "on the wall", points = 2, set = { light = { 1.4, 1.1, 4.8 } }, compare = { color = true } },
    { name = "on the floor", points = 3, set = { light = from_above(), darkness = random.number(0.15, 0.4) },
      compare = { color = true } },
    { name = "a light and a camera that you do not know", points = 3, hidden = true,
      set = { light = random.choice{ from_above(), from_the_front() } },
      camera = { eye = random.point({ -1.5, 0.7, 5.5 }, { 0.5, 1.6, 6.5 }), target = { 0, 0.85, -2 }, fovy = 30 },
      compare = { color = true } },
    { name = "a table-top at a slant", points = 2, hidden = true, scene = "table",
      set = { light = random.point({ -2, 3, -1 }, { 2, 5, 1.5 }) }, compare = { color = true } },
  },
}
