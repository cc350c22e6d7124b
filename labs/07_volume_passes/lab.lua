local table_top = { around = { -0.1, 0.4, 0 }, distance = { 5.5, 7.5 }, elevation = { 22, 50 }, fovy = 40 }
local function above_the_table() return random.point({ -2, 2.6, -1.5 }, { 2, 4.5, 1.5 }) end

return {
  title  = "Shadow volumes in six passes",
  points = 10,
  size   = { 256, 256 },
  scene  = "table",
  cases  = {
    { name = "light of the lecture", points = 2, set = { light = { 2, 4, 1 } }, compare = { color = true } },
    -- Not at random: under this light a stencil that changes while the dark part is drawn shows.
    { name = "another light", points = 2, set = { light = { -1.9, 2.9, 0.36 }, darkness = random.number(0.15, 0.4) },
      compare = { color = true } },
    { name = "seen from anywhere", points = 3, hidden = true, camera = random.camera(table_top),
      set = { light = above_the_table() }, compare = { color = true } },
    { name = "two casters", points = 3, hidden = true, scene = "lamps",
      set = { light = random.point({ -2.6, 2.4, -0.6 }, { -1.6, 3, 0.9 }) }, compare = { color = true } },
  },
}
