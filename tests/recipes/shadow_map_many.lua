-- Recipes of several maps, cubes and cascades, against the truth at 128 × 128.
local visibility = require "visibility"

test("a_cube_of_maps_is_right_for_a_light_inside_of_the_scene", function()
  for _, name in ipairs { "room", "cornell", "table" } do
    local wrong = visibility.wrong("shadow_map_cube", name, { size = 1024 })
    -- Of 16,384 pixels, those within half a texel of an edge.
    expect(wrong <= 40, name .. ": " .. wrong)
  end
end)

-- A cube of six faces is looked up by GL, some of them as layers of an array by the shader; a filter needs
-- the cube, and its unread faces are cleared alone.
test("faces_that_are_left_out_change_no_pixel", function()
  for _, name in ipairs { "room", "cornell", "table", "comb", "stairs", "grass", "teapot", "corner" } do
    for _, filter in ipairs { "NEAREST", "LINEAR" } do
      local set = { cull = "false", keep = "false", filter = filter }
      local all = visibility.render("shadow_map_cube", name, set)
      set.cull = "true"
      local some = visibility.render("shadow_map_cube", name, set)
      expect_equal(all:difference(some).differing, 0, name .. ", " .. filter)
      local drawn = 0
      for _, pass in ipairs(some.passes) do
        if pass:find("1. face", 1, true) and not pass:find("cleared", 1, true) then drawn = drawn + 1 end
      end
      expect(drawn >= 1 and drawn < 6, name .. ", " .. filter .. ": " .. drawn .. " faces were drawn")
      expect_equal(#some.passes, 1 + (filter == "LINEAR" and 6 or drawn), name)
    end
  end
end)

test("a_still_light_draws_its_six_faces_once", function()
  local size = { 64, 64 }
  local first = render("shadow_map_cube", { size = size, set = { cull = "false" } })
  local third = render("shadow_map_cube", { size = size, frames = 3, set = { cull = "false" } })
  local redrawn = render("shadow_map_cube", { size = size, frames = 3, set = { keep = "false", cull = "false" } })
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
