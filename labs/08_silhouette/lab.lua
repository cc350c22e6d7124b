local table_top = { around = { 0, 0.4, 0 }, distance = { 6, 7.5 }, elevation = { 22, 50 }, fovy = 38 }
local function a_lamp() return random.point({ -2.4, 2.6, -1.2 }, { 2.4, 4, 1.2 }) end

return {
  title  = "The silhouette, and the volume that it throws",
  points = 10,
  size   = { 256, 256 },
  scene  = "lamps",
  cases  = {
    { name = "a box and a torus", points = 2, compare = { color = true } },
    { name = "another light", points = 2, set = { light = a_lamp(), darkness = random.number(0.4, 0.7) },
      compare = { color = true } },
    { name = "the counts, seen from anywhere", points = 4, hidden = true, camera = random.camera(table_top),
      set = { light = a_lamp() }, compare = { color = true, stencil = "2. the volumes are counted" } },
    { name = "another caster", points = 2, hidden = true, scene = "tetra",
      set = { light = random.point({ 2.5, 4.5, 1 }, { 5, 6, 3 }) }, compare = { color = true } },
  },
}
