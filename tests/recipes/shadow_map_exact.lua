-- The map without aliasing, at 128 × 128.
local visibility = require "visibility"

-- What is wrong lies at an edge: `shadowlab check shadow_map_exact --scene all --views 100 --size 128` has
-- none beyond. Of 16,384 pixels an edge passes so near to the centres of a few that the rasteriser, which
-- moves corners by 1/512 of a pixel, and the ray see different faces; grass is edges nearly everywhere.
test("hardly_a_pixel_is_wrong", function()
  for name, most in pairs { table = 2, tetra = 1, cornell = 1, city = 3 } do
    local wrong = visibility.wrong("shadow_map_exact", name)
    expect(wrong <= most, name .. ": " .. wrong)
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

-- Over all that casts, the grid holds for any camera.
test("a_still_light_sorts_its_triangles_once", function()
  local size = { 64, 64 }
  local first = render("shadow_map_exact", { size = size, set = { fit = "scene" } })
  local third = render("shadow_map_exact", { size = size, frames = 3, set = { fit = "scene" } })
  expect_equal(#first.passes, 3)
  expect_equal(#third.passes, 2)
  expect_equal(first:difference(third).differing, 0)
end)
