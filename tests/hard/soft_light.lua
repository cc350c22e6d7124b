-- A light with a size against closed forms. Light, caster and receiver are parallel planes at heights
-- H, h and 0; a point x of the receiver and a point l of the light are joined by a line that crosses
-- the caster's plane at x + (l - x) h/H. So a plate, seen from x, hides a rectangle of a square light.
local analytic = require "analytic"

local size = 96
local lamp, H = vec3(0.2, 3, 0.1), 3
local half = vec2(0.6, 0.45)  -- of the plate, which is centred at x = z = 0
-- How far the points of Hammersley's set may be off: their star discrepancy is at most (m/3 + 13/9)/2^m
-- for 2^m (Halton and Zaremba 1969), and 1/2^m along an axis.
local function technique(name, m, set)
  set.shape, set.pattern, set.samples = "square", "hammersley", 1 << m
  return { name = name, set = set, discrepancy = (m / 3 + 13 / 9) / (1 << m), along_axis = 1 / (1 << m) }
end
local techniques = {
  technique("umbra_penumbra", 8, {}),
  technique("soft_accumulated", 6, { technique = "volumes", storage = "float32" }),
  technique("soft_accumulated", 6, { technique = "maps", storage = "float32", size = 1024 }),
  technique("soft_parallelogram", 6, { size = 1024 }),
}
-- An edge may be off by a texel. On the floor those of the map, fitted to the shadow, are at most 4 mm, and
-- those of the floor's own texture, which is filtered, 5 mm.
techniques[3].texel = 0.004
techniques[4].texel, techniques[4].filtered = 0.005, true
local step = 0.5 / 255  -- of the picture's 8 bits

local function render_plate(technique, radius, lift)
  local set = { radius = radius, lift = lift }
  for name, value in pairs(technique.set) do set[name] = value end
  return render(technique.name, { scene = "plate", size = { size, size }, set = set, visibility = true })
end

-- The share of the light's interval [c - s, c + s] that the caster's [-half, half] hides from x.
local function cover(x, c, s, half, h)
  local low, high = (-half - x * (1 - h / H)) * H / h, (half - x * (1 - h / H)) * H / h
  return math.max(0, math.min(high, c + s) - math.max(low, c - s)) / (2 * s)
end

local function visibility(point, s, h)
  local across, along = cover(point.x, lamp.x, s, half.x, h), cover(point.z, lamp.z, s, half.y, h)
  return 1 - across * along, across, along
end

-- Calls visit(point, seen) for the pixels that show the floor: a pixel, of 6 cm at most, within its
-- edges and beside the plate's at height h.
local function each_floor_pixel(picture, h, visit)
  local viewer = analytic.viewer(scene.load("plate").camera, size, size)
  local visited = 0
  for y = 0, size - 1 do
    for x = 0, size - 1 do
      local point = analytic.on_plane(viewer, vec4(0, 1, 0, 0), x, y)
      if point and math.abs(point.x) < 2.44 and math.abs(point.z) < 1.94 then
        local before = analytic.on_plane(viewer, vec4(0, 1, 0, -h), x, y)
        if math.abs(before.x) > half.x + 0.06 or math.abs(before.z) > half.y + 0.06 then
          visited = visited + 1
          visit(point, (picture:color(x, y)) / 255)
        end
      end
    end
  end
  expect(visited > 2000, "hardly a pixel is compared")
end

test("one_hard_shadow_has_no_ramp", function()
  local picture, wrong = render_plate(techniques[1], 0), 0
  each_floor_pixel(picture, 1, function(point, seen)
    if math.abs(seen - (visibility(point, 0.4, 1))) > 0.1 then wrong = wrong + 1 end
  end)
  expect(wrong > 100, "only " .. wrong .. " pixels are wrong")
  naive("a hard shadow is off by more than a tenth in " .. wrong .. " pixels", picture)
end)

test("an_edge_is_a_ramp_and_a_corner_the_product_of_two", function()
  for _, technique in ipairs(techniques) do
    for _, case in ipairs{ { 0.4, 1 }, { 0.25, 1.6 }, { 0.6, 0.3 } } do
      local s, h = case[1], case[2]
      local lift = technique.name == "umbra_penumbra" and h - 1 or nil
      if lift or h == 1 then
        local picture = render_plate(technique, s, lift)
        if h == 1 then ours(technique.name .. ": within its points' discrepancy of the closed form", picture) end
        each_floor_pixel(picture, h, function(point, seen)
          local expected, across, along = visibility(point, s, h)
          local on_edge = across % 1 == 0 or along % 1 == 0
          local off = on_edge and technique.along_axis or technique.discrepancy + 2 * technique.along_axis
          -- Corners are snapped to a 256th of a pixel, of 5 cm at most, across a ramp of half-width p.
          off = off + (0.05 / 256 + (technique.texel or 0)) / (s * h / (H - h)) + step
          expect_near(seen, expected, off,
                      technique.name .. ", light " .. s .. ", height " .. h .. ": the points' discrepancy")
        end)
      end
    end
  end
end)

-- The half-width of a penumbra is s h/(H - h): where it begins and ends, by the least and the greatest x
-- of the pixels that are neither dark nor lit, along the shadow's edge at greater x.
test("the_penumbra_is_as_wide_as_similar_triangles_say", function()
  for _, technique in ipairs(techniques) do
    for _, s in ipairs{ 0.2, 0.4, 0.6 } do
      local picture, h = render_plate(technique, s), 1
      local least, greatest, pixel = math.huge, -math.huge, 5 / size
      each_floor_pixel(picture, 1, function(point, seen)
        local _, across, along = visibility(point, s, h)
        if along == 1 and point.x > 0 and seen > 0 and seen < 1 then
          least, greatest = math.min(least, point.x), math.max(greatest, point.x)
        end
      end)
      local middle, p = half.x + (half.x - lamp.x) * h / (H - h), s * h / (H - h)
      local off = pixel + 2 * p * technique.along_axis + (technique.texel or 0)
      expect_near(least, middle - p, off, technique.name .. ": a pixel, and the last of the points")
      expect_near(greatest, middle + p, off, technique.name .. ": a pixel, and the last of the points")
    end
  end
end)

test("a_light_that_shrinks_to_a_point_gives_the_hard_shadow", function()
  for _, technique in ipairs(techniques) do
    local hard, small = render_plate(technique, 0), render_plate(technique, 1e-9)
    expect_equal(small:difference(hard).differing, 0, technique.name)
    if technique == techniques[1] then ours("of a light of 1e-9 m the shadow of a point", small) end
    local lit, dark = 0, 0
    each_floor_pixel(hard, 1, function(_, seen)
      if seen == 1 then lit = lit + 1 elseif seen == 0 then dark = dark + 1 elseif not technique.filtered then lit = -math.huge end
    end)
    expect(lit > 500 and dark > 200, technique.name .. ": a point's shadow is lit or dark")
  end
end)

test("a_caster_that_nears_its_receiver_loses_its_penumbra", function()
  local before = math.huge
  for _, h in ipairs{ 1, 0.1, 0.01, 0.001 } do
    local between = 0
    each_floor_pixel(render_plate(techniques[1], 0.4, h - 1), h, function(_, seen)
      if seen > 0 and seen < 1 then between = between + 1 end
    end)
    expect(between < before or between == 0, "at height " .. h)
    before = between
  end
  expect_equal(before, 0, "0.3 mm wide, where a pixel has 3 cm: pixels between lit and dark")
  ours "no pixel between lit and dark at a height of 1 mm"
end)

-- Half-width s of the light, w of the plate: the umbra's is w + (w - s) h/(H - h), which is negative.
test("a_light_larger_than_the_caster_and_high_enough_over_it_leaves_no_umbra", function()
  for _, technique in ipairs(techniques) do
    local darkest, expected = 1, 1
    each_floor_pixel(render_plate(technique, 2.2), 1, function(point, seen)
      darkest = math.min(darkest, seen)
      expected = math.min(expected, (visibility(point, 2.2, 1)))
    end)
    expect(expected > 0.3)
    expect_near(darkest, expected, 4 * technique.discrepancy + step + (technique.texel or 0),
                technique.name .. ": a rectangle within the light, four times the discrepancy")
  end
end)

row{ case = 22, title = "A square light over an edge and a corner", expected = "a ramp of half-width s h/(H - h), and the product of two",
     facts = { "one_hard_shadow_has_no_ramp", "an_edge_is_a_ramp_and_a_corner_the_product_of_two", "the_penumbra_is_as_wide_as_similar_triangles_say" } }
row{ case = 23, title = "A light that shrinks, a caster that nears its receiver, a light larger than the caster",
     expected = "the hard shadow; no penumbra; no umbra",
     facts = { "a_light_that_shrinks_to_a_point_gives_the_hard_shadow", "a_caster_that_nears_its_receiver_loses_its_penumbra",
               "a_light_larger_than_the_caster_and_high_enough_over_it_leaves_no_umbra" },
     without = "right too: points on a light of no size are one point" }
