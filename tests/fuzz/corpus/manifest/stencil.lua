local table_top = { around = { -0.1, 0.2, 0 }, distance = { 5.5, 7.5 }, elevation = { 22, 55 }, fovy = 40 }

return {
  title  = "A projected shadow in four passes, by stencil",
  points = 10,
  size   = { 256, 256 },
  scene  = "table",
  cases  = {
    { name = "light of the lecture", points = 2, set = { light = { 2, 4, 1 } }, compare = { color = true } },
    { name = "light and darkness elsewhere", points = 2,
      set = { light = random.point({ -2, 3, -1.5 }, { 2, 5, 1.5 }), darkness = random.number(0.2, 0.5) },
      compare = { color = true } },
    { name = "seen from anywhere", points = 3, hidden = true, camera = random.camera(table_top),
      set = { light = random.point({ -2, 2.5, -1.5 }, { 2, 5, 1.5 }), darkness = random.number(0.2, 0.5) },
      compare = { color = true } },
    { name = "another caster on another plane", points = 3, hidden = true, scene = "tetra",
      set = { light = random.point({ 2.5, 4.5, 1 }, { 5, 6, 3 }), darkness = random.number(0.2, 0.5) },
      compare = { color = true } },
  },
}
