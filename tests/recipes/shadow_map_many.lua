-- Recipes of several maps, cubes and cascades, against the truth at 128 × 128.
local visibility = require "visibility"

test("a_cube_of_maps_is_right_for_a_light_inside_of_the_scene", function()
  for _, name in ipairs { "room", "cornell", "table" } do
    local wrong = visibility.wrong("shadow_map_cube", name, { size = 1024 })
    -- Of 16,384 pixels, those within half a texel of an edge.
    expect(wrong <= 40, name .. ": " .. wrong)
  end
end)

test("faces_that_are_left_out_change_no_pixel", function()
  for _, name in ipairs { "room", "cornell" } do
    local all = visibility.render("shadow_map_cube", name, { cull = "false", keep = "false" })
    local some = visibility.render("shadow_map_cube", name, { cull = "true", keep = "false" })
    expect_equal(all:difference(some).differing, 0, name)
    local left_out = 0
    for _, pass in ipairs(some.passes) do
      if pass:find("no shadow there is seen", 1, true) then left_out = left_out + 1 end
    end
    expect(left_out >= 1, name .. ": every face was drawn")
  end
end)

test("a_still_light_draws_its_six_faces_once", function()
  local size = { 64, 64 }
  local first = render("shadow_map_cube", { size = size })
  local third = render("shadow_map_cube", { size = size, frames = 3 })
  local redrawn = render("shadow_map_cube", { size = size, frames = 3, set = { keep = "false" } })
  expect_equal(#first.passes, 7)
  expect_equal(#third.passes, 1)
  expect_equal(#redrawn.passes, 7)
  expect_equal(first:difference(third).differing, 0)
end)

test("each_way_of_cascading_is_right_near_and_far", function()
  for _, by in ipairs { "view", "camera", "groups" } do
    local wrong = visibility.wrong("shadow_map_cascades", "city", { by = by, size = 1024 })
    expect(wrong <= 40, by .. ": " .. wrong)
  end
end)

test("four_maps_are_better_than_one_of_as_many_texels", function()
  local one = visibility.wrong("shadow_map_cascades", "city", { count = 1, size = 512 })
  local four = visibility.wrong("shadow_map_cascades", "city", { count = 4, size = 256 })
  expect(four * 2 < one, one .. " wrong with one map, " .. four .. " with four")
end)

test("stable_cascades_are_right", function()
  local wrong = visibility.wrong("shadow_map_stable", "city", { size = 1024 })
  expect(wrong <= 40, wrong .. " wrong")
end)

test("moments_are_right_where_shadows_do_not_overlap", function()
  for _, kind in ipairs { "variance", "exponential", "four" } do
    local wrong = visibility.wrong("shadow_map_moments", "tetra", { kind = kind })
    expect(wrong <= 24, kind .. ": " .. wrong)
  end
end)

-- One edge's penumbra is right; where a teapot's parts at several heights are taken for one at their
-- mean, it is not.
test("contact_hardening_is_near_the_soft_truth", function()
  for _, name in ipairs { "tetra", "table" } do
    local soft = visibility.render("shadow_map_pcss", name, { radius = 0.25 })
    local truth = visibility.render("truth", name, { radius = 0.25, samples = 256 })
    local hard = visibility.render("truth", name)
    local rmse, of_hard = soft:difference(truth).rmse, hard:difference(truth).rmse
    expect(rmse < of_hard * 2 / 3, name .. ": " .. rmse .. ", the hard shadow's is " .. of_hard)
  end
end)
