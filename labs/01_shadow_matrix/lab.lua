local function in_the_room() return random.point({ -1.3, 1.9, -0.9 }, { 1.3, 2.7, 1.5 }) end

return {
  title  = "The matrix of a projected shadow",
  points = 10,
  size   = { 256, 256 },
  scene  = "room",
  cases  = {
    { name = "the lab's room", points = 2, compare = { color = true } },
    { name = "another light", points = 2, set = { light = in_the_room() }, compare = { color = true } },
    { name = "a light and a camera that you do not know", points = 3, hidden = true,
      set = { light = in_the_room(), darkness = random.number(0.1, 0.35) },
      camera = { eye = random.point({ -0.7, 1.2, 6.8 }, { 0.7, 2.0, 7.4 }), target = { 0, 1.45, 0 }, fovy = 34 },
      compare = { color = true } },
    { name = "a light beside the casters", points = 3, hidden = true,
      set = { light = random.point({ -0.2, 0.4, 0.5 }, { 0.3, 1.2, 1.4 }) }, compare = { color = true } },
  },
}
