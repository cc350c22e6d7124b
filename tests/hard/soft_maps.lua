-- Contact hardening against the analytic penumbra: of a square light of half-width s at height H, the
-- edge of a plate at height h has a ramp of half-width p = s h / (H - h) (similar triangles).
local visibility = require "visibility"
local analytic = require "analytic"

test("one_occluder_parallel_to_a_square_light_has_the_exact_ramp", function()
  local H, h = 4, 1
  local viewer = analytic.viewer(scene.load("ramp").camera, visibility.size, visibility.size)
  for _, s in ipairs { 0.1, 0.25, 0.5 } do
    local size, taps = 2048, 32
    local p = s * h / (H - h)
    local picture = visibility.render("ramp_pcss", "ramp", { radius = s, shape = "square", size = size, taps = taps })
    -- A texel, on the floor: the map is the plate's and its margin's, seen from 4 metres.
    local texel = 2 * (1 + s) * H / (H - h) / size
    local ramp = 0
    for x = 0, visibility.size - 1 do
      local at = analytic.on_plane(viewer, vec4(0, 1, 0, 0), x, visibility.size // 2).x
      local edge = H / (H - h)
      local expected = math.min(math.max((at - edge + p) / (2 * p), 0), 1)
      if expected > 0 and expected < 1 then ramp = ramp + 1 end
      -- Up to x = 1 the camera sees the plate itself.
      if at > 1 then expect_near(picture:color(x, visibility.size // 2) / 255, expected, 1 / taps + texel / (2 * p) + 1 / 255,
                  "one of the taps' columns, a texel of the ramp, and 8 bits") end
    end
    expect(ramp > 8, s .. ": " .. ramp)
    if s == 0.25 then ours("the ramp, up to the map's texels", picture) end
  end
end)

-- A box filter over a straight edge holds two depths, of which the bounds from moments are exact: the
-- ramp is as wide as the filter, in the map's texels.
test("moments_of_two_depths_give_the_filters_exact_ramp", function()
  local H, h, size, reach = 4, 1, 128, 12
  local viewer = analytic.viewer(scene.load("ramp").camera, visibility.size, visibility.size)
  -- A texel of the fitted map with the blur's room around it: on the floor, at depth 4.
  local _, projection = shadow.light_view(vec4(0, H, 0, 1), scene.load "ramp")
  local texel = 2 / (projection:row(1).x * (1 - 2 * (reach + 1) / size) * size) * H
  local half, edge = (2 * reach + 1) / 2 * texel, H / (H - h)
  for _, kind in ipairs { "variance", "exponential", "four" } do
    local picture = visibility.render("ramp_moments", "ramp", { kind = kind, size = size, reach = reach })
    local ramp = 0
    for x = 0, visibility.size - 1 do
      local at = analytic.on_plane(viewer, vec4(0, 1, 0, 0), x, visibility.size // 2).x
      if at > 1 then
        local expected = math.min(math.max((at - edge + half) / (2 * half), 0), 1)
        if expected > 0 and expected < 1 then ramp = ramp + 1 end
        expect_near(picture:color(x, visibility.size // 2) / 255, expected, 1.5 / (2 * reach + 1) + 0.01,
                    kind .. ": a texel and a half of the filter, and the least variance")
      end
    end
    expect(ramp > 4, kind .. ": " .. ramp)
  end
end)

-- Percentage-closer filtering over the same edge: the ramp is as wide as its filter in the map, wherever
-- the plate is; a square light's would be s h / (H - h), so one width of filter is right at one height.
test("a_filter_of_comparisons_gives_a_ramp_of_its_own_width", function()
  local H, size, number = 4, 128, 8
  local viewer = analytic.viewer(scene.load("ramp").camera, visibility.size, visibility.size)
  local _, projection = shadow.light_view(vec4(0, H, 0, 1), scene.load "ramp")
  local texel = 2 / (projection:row(1).x * size) * H
  for _, weights in ipairs { "equal", "tent" } do
    for _, width in ipairs { 8, 20 } do
      local picture = visibility.render("ramp_pcf", "ramp",
                                        { size = size, number = number, width = width, weights = weights })
      local half, edge, ramp = width / 2 * texel, 4 / 3, 0
      for x = 0, visibility.size - 1 do
        local at = analytic.on_plane(viewer, vec4(0, 1, 0, 0), x, visibility.size // 2).x
        local across = math.min(math.max((at - edge) / half, -1), 1)
        -- The integral of the weights: of the tent, 1 - |x|, a smooth step.
        local expected = weights == "equal" and (1 + across) / 2
                         or across < 0 and (1 + across) ^ 2 / 2 or 1 - (1 - across) ^ 2 / 2
        if expected > 0 and expected < 1 then ramp = ramp + 1 end
        if at > 1 then
          expect_near(picture:color(x, visibility.size // 2) / 255, expected, 1 / number + 1 / width,
                      "one of the taps' columns, and a texel that the hardware blends over")
        end
      end
      expect(ramp >= 4, width .. ": " .. ramp)
      if weights == "equal" and width == 20 then
        naive("one width of filter: a ramp of 20 texels whatever the height", picture)
      end
    end
  end
end)

row{ case = 25, title = "PCSS with one occluder parallel to a square light", expected = "the ramp of half-width s h/(H - h), up to the map's texels",
     facts = { "one_occluder_parallel_to_a_square_light_has_the_exact_ramp", "a_filter_of_comparisons_gives_a_ramp_of_its_own_width" } }
