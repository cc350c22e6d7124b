-- The shadow pulled in front of its plane: whole, and by the offset that the depth buffer shows.
local analytic = require "analytic"
local by_hand = require "by_hand"

local resolution = 2 ^ -24  -- of the main frame's depth buffer
local r = 2 * resolution    -- Mesa's for 24 bits; hard/polygon_offset.lua measures it

-- The larger of |dz/dx| and |dz/dy| of the plane's window depth, which is the same everywhere.
local function slope(viewer)
  local function depth(x, y)
    local _, z = analytic.window(viewer, analytic.on_plane(viewer, by_hand.plane, x, y))
    return z
  end
  return math.max(math.abs(depth(200, 60) - depth(60, 60)) / 140,
                  math.abs(depth(60, 100) - depth(60, 60)) / 40)
end

test("the_shadow_is_whole_in_the_polygon_computed_by_hand", function()
  local picture = by_hand.render("projected_offset", by_hand.light):pass(2)
  local lit = by_hand.render("projected_offset", by_hand.light):pass(1)
  by_hand.each_pixel(by_hand.shadow, function(x, y, what, in_shadow)
    if what ~= "receiver" and what ~= "caster" then return end
    expect_equal(analytic.rgb(picture, x, y),
                 in_shadow and analytic.levels(by_hand.plane_color * 0.25)
                 or analytic.rgb(lit, x, y), x .. ", " .. y)
  end)
end)

test("the_shadow_s_depth_is_the_plane_s_and_the_offset", function()
  for _, case in ipairs{ { -1, -1 }, { -4, 0 }, { -2, -8 }, { 0, -8 } } do
    local factor, units = table.unpack(case)
    local picture = by_hand.render("projected_offset", by_hand.light,
                                   { factor = factor, units = units }):pass(2)
    local plane = by_hand.render("projected_offset", by_hand.light):pass(1)
    by_hand.each_pixel(by_hand.shadow, function(x, y, what, in_shadow, viewer)
      if not in_shadow or what == "background" then return end
      local offset = (picture:depth(x, y) - plane:depth(x, y)) / resolution
      expect_near(offset, (slope(viewer) * factor + r * units) / resolution, 8,
                  "units of 2^-24: clip z and w, of four products each, are floats with four "
                  .. "roundings of 2^-24 of their size; plane and shadow, halved by the window")
    end)
  end
end)

test("the_shadow_leaves_the_receiver_as_its_plane_has_no_end", function()
  local picture = by_hand.render("projected_offset", by_hand.low_light)
  by_hand.each_pixel(by_hand.low_shadow, function(x, y, what, in_shadow)
    if what ~= "background" then return end
    expect_equal(analytic.rgb(picture, x, y),
                 in_shadow and analytic.levels(by_hand.plane_color * 0.25)
                 or analytic.levels(by_hand.background))
  end)
end)

-- With the light below the table all of the teapot is cut from its shadow, and none from itself.
test("the_caster_itself_is_not_cut", function()
  local below = render("projected_offset", { set = { light = "2,-2,1" } })
  local above = render("projected_offset", { set = { light = "2,4,1" } })
  local covered = 0
  for y = 0, 255 do
    for x = 0, 255 do
      local here = below:depth(x, y) < below:pass(2):depth(x, y)
      if here then covered = covered + 1 end
      expect_equal(here, above:depth(x, y) < above:pass(2):depth(x, y))
    end
  end
  expect(covered > 3000, "the teapot is hardly seen")
end)
