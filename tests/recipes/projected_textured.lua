-- Another texture where the stencil says so.
local analytic = require "analytic"
local by_hand = require "by_hand"

local darkness = 0.6  -- the recipe's
local disc, ground = vec3(0.98, 0.80, 0.36), vec3(0.16, 0.20, 0.38)

test("the_stencil_is_that_of_the_shadow_computed_by_hand", function()
  local stencil = by_hand.render("projected_textured", by_hand.light):pass(2)
  by_hand.each_pixel(by_hand.shadow, function(x, y, what, in_shadow)
    if what == "receiver" then
      expect_equal(stencil:stencil(x, y), in_shadow and 0 or 1)
    elseif what == "background" then
      expect_equal(stencil:stencil(x, y), 0)
    end
  end)
end)

test("the_stencil_is_that_of_projected_stencil_bit_for_bit", function()
  for _, scene in ipairs{ "table", "tetra" } do
    local a = render("projected_textured", { scene = scene }):pass(2)
    local b = render("projected_stencil", { scene = scene }):pass(2)
    expect_equal(a:difference(b).stencil, 0, scene)
  end
end)

-- Filtering mixes the texture's two colours: along their line, and never beyond them.
test("in_shadow_there_is_the_second_texture_and_nothing_of_the_first", function()
  local picture = by_hand.render("projected_textured", by_hand.light)
  by_hand.each_pixel(by_hand.shadow, function(x, y, what, in_shadow)
    if what ~= "receiver" then return end
    local seen = analytic.rgb(picture, x, y) / (255 * darkness)
    local along = disc - ground
    local t = (seen - ground):dot(along) / along:dot(along)
    local beside = (seen - (ground + along * t)):length()
    if in_shadow then
      expect(t > -0.02 and t < 1.02 and beside < 0.02,
             "a step of 8 bits, at three fifths of the brightness, is 0.0065 in each channel")
    else
      expect(beside > 0.02, "the tiles' colours are far from that line")
    end
  end)
end)

test("outside_the_shadow_the_first_texture_stays_as_it_was", function()
  local picture = by_hand.render("projected_textured", by_hand.light)
  local before = picture:pass(1)
  by_hand.each_pixel(by_hand.shadow, function(x, y, what, in_shadow)
    if what ~= "caster" and not (what == "receiver" and in_shadow) then
      expect_equal(analytic.rgb(picture, x, y), analytic.rgb(before, x, y))
    end
  end)
end)
