-- Shadow textures against shadows that are projected into the picture itself, from the same points.
local size = 128

local function picture(recipe, scene, radius, samples)
  local set = { radius = radius, pattern = "jitter", seed = 3 }
  if recipe == "room" then
    set.jitters, set.storage = samples, "float32"
  else
    set.samples, set.size = samples, 1024
  end
  return render(recipe, { scene = scene, size = { size, size }, visibility = true, set = set })
end

-- Where there is a surface: the background's colour is each recipe's own.
local function rmse(a, b)
  local sum, count = 0, 0
  for y = 0, size - 1 do
    for x = 0, size - 1 do
      if a:depth(x, y) < 1 then
        count = count + 1
        sum = sum + ((a:color(x, y)) - (b:color(x, y))) ^ 2
      end
    end
  end
  expect(count > size * size / 4)
  return math.sqrt(sum / count) / 255
end

-- The texture is filtered: where a point's shadow ends a pixel is off by a half of 1/N or so. Such pixels
-- are less than 2 % of all, and the N edges are at different places: their squares add up to 0.02/4 /N. A
-- face that counted twice would make all of the penumbra darker.
test("the_textures_hold_the_shadows_that_projection_draws", function()
  for _, scene in ipairs{ "room", "corner" } do
    for _, samples in ipairs{ 1, 4, 16 } do
      local off = rmse(picture("soft_parallelogram", scene, 0.3, samples), picture("room", scene, 0.3, samples))
      expect(off < (0.02 / 4 / samples) ^ 0.5, scene .. ", " .. samples .. " points: " .. off)
    end
  end
end)

test("what_no_point_reaches_is_black_and_what_all_reach_is_white", function()
  local soft, hard = picture("soft_parallelogram", "corner", 0.05, 32), picture("room", "corner", 0.05, 32)
  local dark, lit = 0, 0
  for y = 1, size - 2 do
    for x = 1, size - 2 do
      local least, most = 255, 0
      for v = y - 1, y + 1 do
        for u = x - 1, x + 1 do
          if hard:depth(u, v) == 1 then least = -1 end
          local seen = hard:color(u, v)
          least, most = math.min(least, seen), math.max(most, seen)
        end
      end
      if least == 255 then lit = lit + 1 expect_equal((soft:color(x, y)), 255) end
      if most == 0 and least == 0 then dark = dark + 1 expect_equal((soft:color(x, y)), 0) end
    end
  end
  expect(lit > 1000 and dark > 30, lit .. " lit, " .. dark .. " dark")
end)

test("what_is_no_rectangle_is_refused", function()
  expect_error(function() picture("soft_parallelogram", "stairs", 0.3, 1) end, "is not a rectangle")
end)
