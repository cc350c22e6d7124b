-- A light with a size against closed forms. Light, caster and receiver are parallel planes at heights
-- H, h and 0; a point x of the receiver and a point l of the light are joined by a line that crosses
-- the caster's plane at x + (l - x) h/H. So a plate, seen from x, hides a rectangle of a square light.
local analytic = require "analytic"

local size, samples = 96, 256
local lamp, H = vec3(0.2, 3, 0.1), 3
local half = vec2(0.6, 0.45)  -- of the plate, which is centred at x = z = 0
local techniques = {
  { name = "umbra_penumbra", set = {} },
}

local function render_plate(technique, radius, lift)
  local set = { radius = radius, shape = "square", samples = samples, pattern = "hammersley" }
  for name, value in pairs(technique.set) do set[name] = value end
  if lift then set.lift = lift end
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

-- Calls visit(x, y, point, seen) for the pixels that show the floor, a pixel within its edges.
local function each_floor_pixel(picture, visit)
  local viewer = analytic.viewer(scene.load("plate").camera, size, size)
  local visited = 0
  for y = 0, size - 1 do
    for x = 0, size - 1 do
      local point = analytic.on_plane(viewer, vec4(0, 1, 0, 0), x, y)
      if point and math.abs(point.x) < 2.4 and math.abs(point.z) < 1.9 then
        local _, depth = analytic.window(viewer, point)
        if math.abs(depth - picture:depth(x, y)) < 1e-5 then
          visited = visited + 1
          visit(x, y, point, (picture:color(x, y)) / 255)
        end
      end
    end
  end
  expect(visited > 2000, "hardly a pixel is compared")
end

-- How far 256 Hammersley points may be off: the star discrepancy is at most (8/3 + 13/9)/256 (Halton
-- and Zaremba 1969), and 1/256 along an axis. The picture has 8 bits.
local discrepancy, along_axis = (8 / 3 + 13 / 9) / samples, 1 / samples
local step = 0.5 / 255

test("an_edge_is_a_ramp_and_a_corner_the_product_of_two", function()
  for _, technique in ipairs(techniques) do
    for _, case in ipairs{ { 0.4, 1 }, { 0.25, 1.6 }, { 0.6, 0.3 } } do
      local s, h = case[1], case[2]
      local lift = technique.name == "umbra_penumbra" and h - 1 or nil
      if lift or h == 1 then
        local picture = render_plate(technique, s, lift)
        each_floor_pixel(picture, function(x, y, point, seen)
          local expected, across, along = visibility(point, s, h)
          local edge = across % 1 == 0 or along % 1 == 0
          -- Corners are snapped to a 256th of a pixel, of 5 cm at most, across a ramp of half-width p.
          local snapped = 0.05 / 256 / (s * h / (H - h))
          expect_near(seen, expected,
                      (edge and along_axis or discrepancy + 2 * along_axis) + step + snapped + (technique.more or 0),
                      technique.name .. ", light " .. s .. ", height " .. h .. ": the points' discrepancy, and 8 bits")
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
      each_floor_pixel(picture, function(x, y, point, seen)
        local _, across, along = visibility(point, s, h)
        if along == 1 and point.x > 0 and seen > 0 and seen < 1 then
          least, greatest = math.min(least, point.x), math.max(greatest, point.x)
        end
      end)
      local middle, p = half.x + (half.x - lamp.x) * h / (H - h), s * h / (H - h)
      local off = pixel + 2 * p / samples
      expect_near(least, middle - p, off, technique.name .. ": a pixel, and the last of the points")
      expect_near(greatest, middle + p, off, technique.name .. ": a pixel, and the last of the points")
    end
  end
end)

test("a_light_that_shrinks_to_a_point_gives_the_hard_shadow", function()
  for _, technique in ipairs(techniques) do
    local hard, small = render_plate(technique, 0), render_plate(technique, 1e-9)
    expect_equal(small:difference(hard).differing, 0, technique.name)
    local lit, dark = 0, 0
    each_floor_pixel(hard, function(_, _, _, seen)
      if seen == 1 then lit = lit + 1 elseif seen == 0 then dark = dark + 1 else lit = -math.huge end
    end)
    expect(lit > 500 and dark > 200, technique.name .. ": a point's shadow is lit or dark")
  end
end)

test("a_caster_that_nears_its_receiver_loses_its_penumbra", function()
  local touching = { name = "umbra_penumbra", set = {} }
  local before = math.huge
  for _, h in ipairs{ 1, 0.1, 0.01, 0.001 } do
    local between = 0
    each_floor_pixel(render_plate(touching, 0.4, h - 1), function(_, _, _, seen)
      if seen > 0 and seen < 1 then between = between + 1 end
    end)
    expect(between < before, "at height " .. h)
    before = between
  end
  -- 0.3 mm wide, where a pixel has 3 cm and more: a hundredth of the pixels along the shadow's edge.
  expect(before <= 4, before .. " pixels are between lit and dark")
end)

-- Half-width s of the light, w of the plate: the umbra's is w + (w - s) h/(H - h), which is negative.
test("a_light_larger_than_the_caster_and_high_enough_over_it_leaves_no_umbra", function()
  for _, technique in ipairs(techniques) do
    local darkest, expected = 1, 1
    each_floor_pixel(render_plate(technique, 2.2), function(_, _, point, seen)
      darkest = math.min(darkest, seen)
      expected = math.min(expected, (visibility(point, 2.2, 1)))
    end)
    expect(expected > 0.3)
    expect_near(darkest, expected, 4 * discrepancy + step + (technique.more or 0),
                technique.name .. ": a rectangle within the light, four times the discrepancy")
  end
end)
