-- The recipe at 80 × 80: cells of 20 × 16, four attachments across, five rows.
local analytic = require "analytic"

local red, green, blue, yellow = vec3(255, 0, 0), vec3(0, 255, 0), vec3(0, 0, 255), vec3(255, 255, 0)
local magenta, gray, white = vec3(255, 0, 255), vec3(51, 51, 51), vec3(255, 255, 255)

-- `expected(column, x, y)` of each pixel of a row of cells, x and y within the cell.
local function expect_row(row, expected)
  local p = render("fbo_draw_buffers", { size = { 80, 80 } })
  for y = 0, 15 do
    for x = 0, 79 do
      expect_equal(analytic.rgb(p, x, 16 * row + y), expected(x // 20, x % 20, y),
                   "column " .. x // 20 .. ", " .. x % 20 .. ", " .. y)
    end
  end
end

test("output_i_reaches_the_attachment_that_draw_buffer_i_names", function()
  local of = { [0] = yellow, green, gray, red }
  expect_row(4, function(column) return of[column] end)
end)

test("a_single_colour_reaches_every_draw_buffer_and_no_other_attachment", function()
  expect_row(3, function(column) return column % 2 == 0 and magenta or gray end)
end)

test("blending_is_switched_for_one_draw_buffer", function()
  local p = render("fbo_draw_buffers", { size = { 80, 80 } })
  -- 51/255 + 0.5 green, in 8 bits: 0.2 + 0.5 = 178.5/255.
  expect_near(analytic.rgb(p, 30, 40), vec3(51, 178.5, 51), 0.5, "the sum lies between two steps of 8 bits")
  local of = { [0] = red, analytic.rgb(p, 30, 40), blue, yellow }
  expect_row(2, function(column) return of[column] end)
end)

test("the_index_of_the_scissor_test_is_a_viewports_not_a_draw_buffers", function()
  local of = { [0] = red, green, blue, yellow }
  expect_row(1, function(column, x)
    return (column >= 2 or x < 10) and of[column] or gray
  end)
end)

test("a_shared_depth_buffer_hides_and_the_smallest_attachment_bounds_what_is_drawn", function()
  expect_row(0, function(column, x, y)
    if column == 0 then return x < 5 and red or gray end
    if column == 3 or x >= 10 or y >= 8 then return white end
    return x < 5 and gray or green
  end)
end)

test("each_status_is_what_its_words_say", function()
  frame(16, 16, function()
    for _, case in ipairs(require "parts.completeness") do
      local fbo = gl.GenFramebuffers(1)
      gl.BindFramebuffer(gl.DRAW_FRAMEBUFFER, fbo)
      case.build()
      expect_equal(gl.CheckFramebufferStatus(gl.DRAW_FRAMEBUFFER), gl[case.status], case.words)
      expect_equal(gl.CheckNamedFramebufferStatus(fbo, gl.DRAW_FRAMEBUFFER), gl[case.status], case.words)
    end
  end)
end)
