-- The map without aliasing, at 128 × 128.
local visibility = require "visibility"

-- Rounding decides a pixel whose centre is within a millionth of the map from an edge: of 16,384 pixels
-- none or one.
test("no_pixel_is_wrong_but_by_rounding", function()
  for _, name in ipairs { "table", "tetra", "cornell", "city" } do
    local wrong = visibility.wrong("shadow_map_exact", name)
    expect(wrong <= 1, name .. ": " .. wrong)
  end
end)

test("the_grids_size_changes_no_pixel", function()
  local one = visibility.render("shadow_map_exact", "tetra", { cells = 1 })
  for _, cells in ipairs { 2, 7, 33, 300 } do
    local some = visibility.render("shadow_map_exact", "tetra", { cells = cells })
    expect_equal(one:difference(some).differing, 0, cells .. " cells")
  end
  local coarse = visibility.render("shadow_map_exact", "table", { cells = 40 })
  local fine = visibility.render("shadow_map_exact", "table", { cells = 250 })
  expect_equal(coarse:difference(fine).differing, 0)
end)

-- Where this one is wrong in none.
test("a_map_of_depths_of_64_texels_is_wrong_in_many_pixels", function()
  local wrong = visibility.wrong("shadow_map_fbo", "table", { size = 64 })
  expect(wrong >= 10, wrong .. " wrong")
end)

local triangle_grid = require "parts.triangle_grid"

-- Every triangle is in the list of each cell that one of its points is in, and of few others.
test("a_cell_lists_every_triangle_that_reaches_into_it", function()
  local world, cells = scene.load "tetra", 24
  local view, projection, near = shadow.light_view(vec4(4, 5, 2, 1), world)
  local to_texture = shadow.bias_matrix() * projection * view
  local grid = triangle_grid.build(world.casters, to_texture, near / 2, cells)
  expect_equal(grid.count, 4)
  local function listed(x, y)
    local cell, found = y * cells + x, {}
    for i = 1, grid.ranges[2 * cell + 2] do found[grid.list[grid.ranges[2 * cell + 1] + i]] = true end
    return found
  end
  local points = 0
  for t = 0, 3 do
    local n = grid.triangles
    local a = vec2(n[12 * t + 1], n[12 * t + 2])
    local b, c = vec2(n[12 * t + 3], n[12 * t + 4]), vec2(n[12 * t + 5], n[12 * t + 6])
    for i = 0, 60 do
      for j = 0, 60 - i do
        local p = a + (b - a) * (i / 60) + (c - a) * (j / 60)
        local x, y = math.floor(p.x * cells), math.floor(p.y * cells)
        if p.x > 0 and p.y > 0 and x < cells and y < cells then
          points = points + 1
          expect(listed(x, y)[t], "triangle " .. t .. " at " .. x .. ", " .. y)
        end
      end
    end
  end
  expect(points > 5000, points .. " points")
  expect(#grid.list < 4 * cells * cells * 0.7, "cells list what does not reach into them: " .. #grid.list)
end)
