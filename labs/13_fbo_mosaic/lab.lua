local around_it = { around = { 0.1, 0.48, 0 }, distance = { 3.3, 4.2 }, elevation = { 10, 45 }, fovy = 36 }
local function a_lamp() return random.point({ -4, 2, 2 }, { 4, 5, 6 }) end

return {
  title  = "A mosaic from a framebuffer object",
  points = 10,
  size   = { 320, 240 },
  scene  = "teapot",
  cases  = {
    { name = "the lecture's teapot", points = 2, compare = { color = true } },
    { name = "another light and camera", points = 3, set = { light = a_lamp() }, camera = random.camera(around_it),
      compare = { color = true } },
    { name = "a framebuffer of another size", points = 3, hidden = true,
      set = { light = a_lamp(), fbowidth = random.choice{ 160, 480 }, fboheight = random.choice{ 200, 300 } },
      camera = random.camera(around_it), compare = { color = true } },
    { name = "another scene", points = 2, hidden = true, scene = "cube", set = { light = a_lamp() },
      compare = { color = true } },
  },
}
