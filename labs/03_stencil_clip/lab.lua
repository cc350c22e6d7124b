return {
  title  = "A shadow that ends where its receiver does",
  points = 10,
  size   = { 256, 256 },
  scene  = "corner",
  cases  = {
    { name = "across the corner", points = 2, set = { light = { 1.6, 2.9, 3.2 } }, compare = { color = true } },
    { name = "another light", points = 3, set = { light = random.point({ -1.6, 2.4, 2.6 }, { 1.6, 3.2, 3.6 }) },
      compare = { color = true } },
    { name = "a light and a camera that you do not know", points = 3, hidden = true,
      set = { light = random.point({ -1.6, 2.4, 2.6 }, { 1.6, 3.2, 3.6 }), darkness = random.number(0.1, 0.4) },
      camera = { eye = random.point({ -1.5, 0.7, 5.5 }, { 1.5, 1.6, 6.5 }), target = { 0, 0.85, -2 }, fovy = 30 },
      compare = { color = true } },
    { name = "past the edge of a table", points = 2, hidden = true, scene = "table",
      set = { light = random.point({ 1, 2.5, -1 }, { 2.5, 3.5, 1.5 }) }, compare = { color = true } },
  },
}
