-- The stencil buffer's recipe at 256 × 256: its quads' edges are at pixels 32, 160 and 96, 224.
local analytic = require "analytic"

local function in_first(x, y) return 32 <= x and x < 160 and 32 <= y and y < 160 end
local function in_second(x, y) return 96 <= x and x < 224 and 96 <= y and y < 224 end

local function expect_color(p, x, y, color)
  expect_equal(analytic.rgb(p, x, y), analytic.levels(color), "pixel " .. x .. ", " .. y)
end

test("replace_writes_the_reference_where_the_quad_is_drawn_and_nowhere_else", function()
  local p = render("stencil_basics"):pass(1)
  for y = 0, 255 do
    for x = 0, 255 do expect_equal(p:stencil(x, y), in_first(x, y) and 1 or 0) end
  end
end)

test("a_quad_tested_equal_0_is_drawn_outside_the_first_and_leaves_the_stencil", function()
  local picture = render("stencil_basics")
  local p = picture:pass(2)
  for y = 0, 255 do
    for x = 0, 255 do
      expect_color(p, x, y, in_first(x, y) and vec3(0.36, 0.56, 0.84)
                            or in_second(x, y) and vec3(0.94, 0.66, 0.32)
                            or vec3(0.93, 0.93, 0.90))
    end
  end
  expect_equal(picture:pass(1):difference(p).stencil, 0)
end)

-- The digits 0 and 1, in dots of 2 pixels in the middle of cells of 16.
local glyphs = { [0] = { " # ", "# #", "# #", "# #", " # " },
                 [1] = { " # ", "## ", " # ", " # ", "###" } }

test("every_cell_shows_the_value_that_its_stencil_has", function()
  local picture = render("stencil_basics")
  local before = picture:pass(2)
  for y = 0, 255 do
    for x = 0, 255 do
      local value = in_first(x, y) and 1 or 0
      local column, row = (x % 16 - 5) // 2 + 1, 5 - (y % 16 - 3) // 2
      if row >= 1 and row <= 5 and column >= 1 and column <= 3
         and glyphs[value][row]:sub(column, column) == "#" then
        expect_color(picture, x, y, value == 0 and vec3(0.45, 0.45, 0.42) or vec3(1))
      else
        expect_equal(vec4(picture:color(x, y)), vec4(before:color(x, y)), x .. ", " .. y)
      end
    end
  end
end)
