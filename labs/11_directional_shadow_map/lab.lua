local table_top = { around = { -0.1, 0.3, 0 }, distance = { 5.5, 7.5 }, elevation = { 25, 55 }, fovy = 40 }
local function sun() return { random.number(-1, 1), random.number(0.9, 1.4), random.number(-0.8, 0.8) } end

return {
  title  = "A shadow map of the sun",
  points = 10,
  size   = { 256, 256 },
  cases  = {   -- of the recipe's own scene: another one would bring its own light, a lamp
    { name = "the sun of the lesson", points = 2, compare = { color = true } },
    { name = "another sun", points = 3, set = { light = sun() },
      compare = { color = true, depth = "2. the scene, with the map" } },
    { name = "seen from anywhere", points = 3, hidden = true, camera = random.camera(table_top),
      set = { light = sun(), darkness = random.number(0.15, 0.4), size = random.choice{ 64, 72, 80 } }, compare = { color = true } },
    -- Texels of two pixels and more, here and above: which box the map covers, and how it is read, is to be seen.
    { name = "a map whose texels are seen", points = 2, hidden = true, set = { light = sun(), size = random.choice{ 40, 48, 56 } },
      compare = { color = true } },
  },
}
