-- The plain shadow is the whole polygon on the plane, black, and the caster is over it.
local analytic = require "analytic"
local by_hand = require "by_hand"

test("the_shadow_is_black_in_the_polygon_computed_by_hand", function()
  local picture = by_hand.render("projected_plain", by_hand.light)
  local lit = picture:pass(1)
  by_hand.each_pixel(by_hand.shadow, function(x, y, what, in_shadow)
    if what ~= "receiver" then return end
    expect_equal(analytic.rgb(picture, x, y), in_shadow and vec3(0) or analytic.rgb(lit, x, y))
  end)
end)

test("the_shadow_leaves_the_receiver_as_its_plane_has_no_end", function()
  local picture = by_hand.render("projected_plain", by_hand.low_light)
  local hanging = 0
  by_hand.each_pixel(by_hand.low_shadow, function(x, y, what, in_shadow)
    if what ~= "background" then return end
    if in_shadow then hanging = hanging + 1 end
    expect_equal(analytic.rgb(picture, x, y),
                 in_shadow and vec3(0) or analytic.levels(by_hand.background))
  end)
  expect(hanging > 100)
end)

test("without_a_depth_test_the_shadow_leaves_depth_as_it_was", function()
  local picture = by_hand.render("projected_plain", by_hand.light)
  local before, after = picture:pass(1), picture:pass(2)
  for y = 0, by_hand.size - 1 do
    for x = 0, by_hand.size - 1 do expect_equal(after:depth(x, y), before:depth(x, y)) end
  end
end)

test("the_caster_covers_its_shadow", function()
  local picture = by_hand.render("projected_plain", by_hand.light)
  by_hand.each_pixel(by_hand.shadow, function(x, y, what)
    if what == "caster" then expect(analytic.rgb(picture, x, y) ~= vec3(0)) end
  end)
end)
