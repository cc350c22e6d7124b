local function before_the_wall() return random.point({ -1.6, 2.4, 2.6 }, { 1.6, 3.2, 3.6 }) end

return {
  title  = "A projected shadow without z-fighting",
  points = 10,
  size   = { 256, 256 },
  scene  = "corner",
  cases  = {
    { name = "a floor and a wall", points = 2, set = { light = { 1.6, 2.9, 3.2 } }, compare = { color = true } },
    { name = "another light", points = 3, set = { light = before_the_wall(), darkness = random.number(0.15, 0.4) },
      compare = { color = true } },
    { name = "a light and a camera that you do not know", points = 3, hidden = true,
      set = { light = before_the_wall() },
      camera = { eye = random.point({ -1.5, 0.7, 5.5 }, { 1.5, 1.6, 6.5 }), target = { 0, 0.85, -2 }, fovy = 30 },
      compare = { color = true } },
    { name = "a table-top at a slant", points = 2, hidden = true, scene = "table",
      set = { light = random.point({ -2, 3, -1 }, { 2, 5, 1.5 }) }, compare = { color = true } },
  },
}
