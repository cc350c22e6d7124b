local table_top = { around = { -0.1, 0.3, 0 }, distance = { 5, 7 }, elevation = { 25, 55 }, fovy = 40 }
local function above_the_table() return random.point({ -2.2, 3, -1.5 }, { 2.2, 5, 1.5 }) end

return {
  title  = "Percentage-closer filtering",
  points = 10,
  size   = { 256, 256 },
  scene  = "table",
  cases  = {
    { name = "light of the lecture", points = 2, compare = { color = true } },
    { name = "another light", points = 3, set = { light = above_the_table(), darkness = random.number(0.1, 0.3) },
      compare = { color = true } },
    { name = "a wider filter", points = 2, hidden = true, set = { light = above_the_table(), reach = 3 },
      compare = { color = true } },
    { name = "seen from anywhere", points = 3, hidden = true, camera = random.camera(table_top),
      set = { light = above_the_table(), reach = random.choice{ 1, 2 } }, compare = { color = true } },
  },
}
