-- The mosaic at 128 × 128, pixel by pixel, from the picture of the teapot drawn straight to the frame.
local analytic = require "analytic"
local size = 128

local function source(side)
  return frame(side, side, function()
    local teapot = scene.load "teapot"
    gl.ClearColor(0.85, 0.88, 0.92, 1)
    gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
    gl.Enable(gl.DEPTH_TEST)
    teapot:draw(shader.load "phong", { view = teapot.camera:view(), projection = teapot.camera:projection(1),
                                       light = vec4(3, 4, 5, 1) })
  end)
end

local function mosaic(set) return render("fbo_blit", { size = { size, size }, set = set }) end

-- Calls visit for each pixel of each of the ten copies: its place in the mosaic, in its copy, and the
-- copy's side; what is in the upper right and lower right is flipped.
local function each_pixel(visit)
  local half, quarter = size // 2, size // 4
  for y = 0, size - 1 do
    for x = 0, size - 1 do
      local left, lower = x < half, y < half
      local side = left == lower and quarter or half
      visit(x, y, x % side, y % side, side, not left)
    end
  end
end

test("a_half_is_the_picture_itself_and_its_turned_copy_has_each_pixel_across", function()
  local p, teapot = mosaic { halves = 1 }, source(size // 2)
  each_pixel(function(x, y, i, j, side, flipped)
    if side ~= size // 2 then return end
    if flipped then i, j = side - 1 - i, side - 1 - j end
    expect_equal(analytic.rgb(p, x, y), analytic.rgb(teapot, i, j), x .. ", " .. y)
  end)
end)

test("rectangles_reversed_in_one_direction_flip_in_that_one", function()
  local teapot = source(size // 2)
  for _, flip in ipairs { "horizontal", "vertical", "none" } do
    local p = mosaic { halves = 1, flip = flip }
    each_pixel(function(x, y, i, j, side, flipped)
      if side ~= size // 2 then return end
      if flipped and flip == "horizontal" then i = side - 1 - i end
      if flipped and flip == "vertical" then j = side - 1 - j end
      expect_equal(analytic.rgb(p, x, y), analytic.rgb(teapot, i, j), flip)
    end)
  end
end)

-- A pixel of a quarter covers 2 × 2 of the source; its centre is their corner.
test("linear_gives_the_mean_of_the_four_that_a_quarters_pixel_covers", function()
  local p, teapot = mosaic { halves = 1 }, source(size // 2)
  each_pixel(function(x, y, i, j, side, flipped)
    if side ~= size // 4 then return end
    if flipped then i, j = side - 1 - i, side - 1 - j end
    local mean = (analytic.rgb(teapot, 2 * i, 2 * j) + analytic.rgb(teapot, 2 * i + 1, 2 * j)
                  + analytic.rgb(teapot, 2 * i, 2 * j + 1) + analytic.rgb(teapot, 2 * i + 1, 2 * j + 1)) / 4
    expect_near(analytic.rgb(p, x, y), mean, 1.5,
                "llvmpipe rounds each of the three interpolations to 8 bits, by half a step")
  end)
end)

test("nearest_gives_one_of_the_four_and_never_a_mixture", function()
  local p, teapot = mosaic { halves = 1, filter = "NEAREST" }, source(size // 2)
  each_pixel(function(x, y, i, j, side, flipped)
    if side ~= size // 4 then return end
    if flipped then i, j = side - 1 - i, side - 1 - j end
    local found = false
    for k = 0, 3 do
      found = found or analytic.rgb(p, x, y) == analytic.rgb(teapot, 2 * i + k % 2, 2 * j + k // 2)
    end
    expect(found, x .. ", " .. y)
  end)
end)

-- Three pixels to one: the centre is a pixel's centre, where both filters give that pixel.
test("at_three_to_one_both_filters_give_the_middle_pixel", function()
  local teapot = source(3 * size // 2)
  for _, filter in ipairs { "LINEAR", "NEAREST" } do
    local p = mosaic { halves = 3, filter = filter }
    each_pixel(function(x, y, i, j, side, flipped)
      if side ~= size // 2 then return end
      if flipped then i, j = side - 1 - i, side - 1 - j end
      expect_equal(analytic.rgb(p, x, y), analytic.rgb(teapot, 3 * i + 1, 3 * j + 1), filter)
    end)
  end
end)

test("functions_that_name_their_object_draw_the_same_as_those_that_act_on_what_is_bound", function()
  for _, filter in ipairs { "LINEAR", "NEAREST" } do
    local bound, named = mosaic { filter = filter }, mosaic { filter = filter, names = "named" }
    expect_equal(bound:difference(named).differing, 0, filter)
  end
end)
