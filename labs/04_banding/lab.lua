local function a_color()
  return { random.number(0.75, 1), random.number(0.3, 1), random.number(0.3, 1) }
end

return {
  title  = "An average without bands",
  points = 10,
  size   = { 256, 256 },
  cases  = {
    { name = "the lecture's red ramp", points = 2, compare = { color = true } },
    { name = "another ramp", points = 2, set = { color = a_color(), tilt = random.number(10, 80) },
      compare = { color = true } },
    { name = "more drawings", points = 3, hidden = true,
      set = { times = random.choice{ 24, 32, 40 }, color = a_color(), tilt = random.number(100, 260) },
      compare = { color = true } },
    { name = "an odd number of drawings", points = 3, hidden = true,
      set = { times = random.choice{ 17, 19, 23, 29 }, color = a_color(), tilt = random.number(280, 350) },
      compare = { color = true } },
  },
}
