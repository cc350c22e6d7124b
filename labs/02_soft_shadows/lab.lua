local function in_the_room() return random.point({ -0.9, 1.9, -0.4 }, { 0.9, 2.4, 1.2 }) end

return {
  title  = "Soft shadows by the accumulation buffer",
  points = 10,
  size   = { 256, 256 },
  scene  = "room",
  cases  = {
    { name = "eight jitters", points = 2, compare = { color = true } },
    { name = "another light", points = 2, set = { light = in_the_room() }, compare = { color = true } },
    { name = "another number of jitters", points = 3, hidden = true,
      set = { light = in_the_room(), numJitters = random.choice{ 5, 6, 7, 12 } }, compare = { color = true } },
    { name = "another size of the lamp", points = 3, hidden = true,
      set = { light = in_the_room(), radius = random.number(0.2, 0.4) },
      camera = { eye = random.point({ -0.7, 1.2, 6.8 }, { 0.7, 2.0, 7.4 }), target = { 0, 1.45, 0 }, fovy = 34 },
      compare = { color = true } },
  },
}
