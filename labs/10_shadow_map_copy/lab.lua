local table_top = { around = { -0.1, 0.3, 0 }, distance = { 5.5, 7.5 }, elevation = { 25, 55 }, fovy = 40 }
local function above_the_table() return random.point({ -2.2, 3, -1.5 }, { 2.2, 5, 1.5 }) end

return {
  title  = "A shadow map, copied from the depth buffer",
  points = 10,
  size   = { 320, 256 },
  scene  = "table",
  cases  = {
    { name = "light of the lecture", points = 2, set = { light = { 2, 4, 1 } }, compare = { color = true } },
    { name = "another light", points = 3, set = { light = above_the_table(), darkness = random.number(0.15, 0.4) },
      compare = { color = true } },
    { name = "seen from anywhere", points = 3, hidden = true, camera = random.camera(table_top),
      set = { light = above_the_table() },
      compare = { color = true, depth = "2. the scene, compared with the map" } },
    { name = "two casters", points = 2, hidden = true, scene = "lamps",
      set = { light = random.point({ -2.6, 3, -0.6 }, { 2.6, 4, 1.2 }) }, compare = { color = true } },
  },
}
