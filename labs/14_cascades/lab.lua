local function sun() return { random.number(0.45, 0.8), random.number(0.55, 0.9), random.number(0.15, 0.45) } end
local function down_the_street()
  local x = random.number(-1.5, 1.5)
  return { eye = { x, random.number(1.7, 2.6), random.number(2, 8) },
           target = { random.number(-1.5, 1.5), 1.6, -40 }, fovy = 50 }
end

return {
  title  = "Cascaded shadow maps",
  points = 10,
  size   = { 256, 256 },
  scene  = "city",
  cases  = {
    { name = "the street", points = 2, compare = { color = true } },
    { name = "another sun", points = 3, set = { light = sun() }, compare = { color = true } },
    { name = "from elsewhere in the street", points = 3, hidden = true, camera = down_the_street(),
      set = { light = sun() }, compare = { color = true } },
    -- Maps so coarse that it is seen which part of the view each of them covers.
    { name = "splits nearer to uniform, and coarse maps", points = 2, hidden = true,
      set = { light = sun(), lambda = random.number(0.3, 0.6), darkness = random.number(0.15, 0.4),
              size = random.choice{ 48, 56, 64 } },
      compare = { color = true } },
  },
}
