-- Where the panels' shadows are whole: what the stencil's recipe, which tests no depth, finds to be
-- in shadow, at the size of a panel.
local analytic = require "analytic"

local width, height = 256, 256
local light = vec3(1.6, 2.9, 3.2)
local world = scene.load "corner"
local panels = { ["no offset"] = { 0, 1 }, ["factor and units"] = { 1, 1 }, ["factor"] = { 0, 0 },
                 ["units"] = { 1, 0 } }

-- The window row at which the wall stands on the floor.
local viewer = analytic.viewer(world.camera, width, height)
local corner = analytic.window(viewer, vec3(0, 0, -2.5)).y

-- For each panel and receiver, the part of the receiver's shadow that is drawn, 0 to 1, a pixel or
-- more from the corner: a factor of 1 pulls the floor's shadow forward by the depth of one pixel, and
-- so over the wall's lowest pixels, behind which the floor's plane goes on.
local function covered(set)
  set = set or {}
  set.light = light
  local picture = render("zfighting", { size = { 2 * width, 2 * height }, set = set })
  local reference = render("projected_stencil", { scene = "corner", size = { width, height },
                                                  set = { light = light } })
  local receivers = reference:pass(3)
  local stencil = reference:pass(2)
  local shares = {}
  for panel, place in pairs(panels) do shares[panel] = { floor = { 0, 0 }, wall = { 0, 0 } } end
  for y = 1, height - 2 do
    for x = 1, width - 2 do
      local whole = math.abs(y + 0.5 - corner) >= 1
      for dy = -1, 1 do
        for dx = -1, 1 do
          whole = whole and stencil:stencil(x + dx, y + dy) == 0
                  and reference:depth(x + dx, y + dy) == receivers:depth(x + dx, y + dy)
                  and reference:depth(x + dx, y + dy) < 1
        end
      end
      if whole then
        local name = y < corner and "floor" or "wall"
        local dark = analytic.levels(world:object(name).color * 0.25)
        for panel, place in pairs(panels) do
          local share = shares[panel][name]
          share[2] = share[2] + 1
          local seen = analytic.rgb(picture, x + place[1] * width, y + place[2] * height)
          if seen == dark then share[1] = share[1] + 1 end
        end
      end
    end
  end
  local parts = {}
  for panel, by_receiver in pairs(shares) do
    parts[panel] = {}
    for name, share in pairs(by_receiver) do
      expect(share[2] > 300, "hardly a pixel of the " .. name .. " is in shadow")
      parts[panel][name] = share[1] / share[2]
    end
  end
  return parts
end

test("without_an_offset_the_shadow_is_torn_on_both", function()
  local part = covered()["no offset"]
  expect(part.floor < 0.95, "the floor's is " .. part.floor)
  expect(part.wall < 0.95, "the wall's is " .. part.wall)
end)

test("factor_and_units_make_the_floor_s_shadow_whole", function()
  expect_equal(covered()["factor and units"].floor, 1)
end)

test("the_factor_alone_is_enough_for_the_steep_floor_and_not_for_the_wall", function()
  local part = covered()["factor"]
  expect_equal(part.floor, 1)
  expect(part.wall < 0.95, "the wall's is " .. part.wall)
end)

test("units_alone_are_not_enough_for_the_steep_floor", function()
  local part = covered()["units"]
  expect(part.floor < 1, "the floor's is whole")
end)

-- One of Mesa's units is two of the depth buffer's. Depth is z/w of two floats, each with a few
-- roundings of 2^-24 of its size, which the flattened caster and the wall do not share.
test("enough_units_make_the_wall_s_shadow_whole", function()
  local part = covered{ units = -8 }
  expect_equal(part["units"].wall, 1)
  expect_equal(part["factor and units"].wall, 1)
  expect_equal(part["factor and units"].floor, 1)
end)

test("each_panel_is_drawn_within_its_quarter", function()
  local picture = render("zfighting", { size = { 128, 128 } })
  local margin = analytic.levels(vec3(0.15, 0.15, 0.18))
  for i = 0, 127 do
    for _, edge in ipairs{ 0, 63, 64, 127 } do
      expect_equal(analytic.rgb(picture, edge, i), margin)
      expect_equal(analytic.rgb(picture, i, edge), margin)
    end
  end
end)
