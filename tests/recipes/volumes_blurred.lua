-- The blur against similar triangles, and against rays to all of the light.
local analytic = require "analytic"

local size, radius = 160, 0.2
local lamp, floor = vec3(0, 1.5, 2), vec4(0, 1, 0, 0)

local function wall(blur)
  return render("volumes_blurred", { scene = "wall", size = { size, size }, visibility = true,
                                  set = { blur = blur, radius = radius, width = 6 } })
end

-- Calls visit(x, y, point) for the floor's pixels behind the wall, away from it and from the border,
-- where what a blur needs would be out of the picture.
local function each_floor_pixel(visit)
  local viewer = analytic.viewer(scene.load("wall").camera, size, size)
  local visited = 0
  for y = 4, size - 5 do
    for x = 4, size - 5 do
      local point = analytic.on_plane(viewer, floor, x, y)
      if point.z < -0.3 and point.z > -4 and point.x > -1 then
        visited = visited + 1
        visit(x, y, point)
      end
    end
  end
  expect(visited > 5000, "hardly a pixel is compared")
end

-- A sphere sampled over its surface is, along any axis, as dense everywhere (Archimedes): behind a
-- straight edge its visibility is a ramp. Half its width is R d / D, d behind the edge, D before it.
local function ramp(point)
  local half_width = radius * -point.z / lamp.z
  return math.min(math.max(0.5 + point.x / (2 * half_width), 0), 1), half_width
end

local pixel = 2 * 6 * math.tan(math.rad(24)) / size  -- on the floor, metres

test("the_penumbra_of_a_wall_is_the_ramp_of_similar_triangles", function()
  local picture = wall "contact"
  each_floor_pixel(function(x, y, point)
    local expected, half_width = ramp(point)
    expect_near(picture:color(x, y) / 255, expected, 0.03 + pixel / (2 * half_width),
                "the hard shadow is known to a pixel, and the light as 96 points: " .. x .. ", " .. y)
  end)
end)

-- The distance across the shadow's edge over which the visibility goes from 0.1 to 0.9, in metres, at
-- the pixels whose z is within a tenth of `z`.
local function width_at(picture, z)
  local least, most = math.huge, -math.huge
  each_floor_pixel(function(x, y, point)
    local seen = picture:color(x, y) / 255
    if math.abs(point.z - z) < 0.1 and seen > 0.1 and seen < 0.9 then
      least, most = math.min(least, point.x), math.max(most, point.x)
    end
  end)
  return math.max(most - least, 0)
end

test("far_from_the_contact_the_shadow_is_wider_than_near_it", function()
  local picture = wall "contact"
  local near, far = width_at(picture, -1), width_at(picture, -3.5)
  expect_near(near, 0.8 * 2 * radius * 1 / lamp.z, 2 * pixel, "a pixel at either end")
  expect_near(far, 0.8 * 2 * radius * 3.5 / lamp.z, 2 * pixel, "a pixel at either end")
end)

test("an_even_blur_is_as_wide_everywhere_and_no_blur_is_none", function()
  local picture = wall "even"
  expect_near(width_at(picture, -1), width_at(picture, -3.5), 2 * pixel, "a pixel at either end")
  expect(width_at(picture, -1) > 5 * pixel)
  expect_equal(width_at(wall "none", -3.5), 0)
end)

-- Sums of weights over their sum: 96 times 1 over 96 is 1.
test("what_is_lit_or_dark_all_around_stays_exactly_so", function()
  local contact, even = wall "contact", wall "even"
  each_floor_pixel(function(x, y, point)
    local lit, half_width = ramp(point)
    if math.abs(point.x) > half_width + 2 * pixel then
      expect_equal(contact:color(x, y), 255 * lit, "contact " .. x .. ", " .. y)
    end
    if math.abs(point.x) > 8 * pixel then
      expect_equal(even:color(x, y), point.x > 0 and 255 or 0, "even " .. x .. ", " .. y)
    end
  end)
end)

test("a_light_that_shrinks_to_a_point_leaves_the_hard_shadow", function()
  for _, scene in ipairs{ "table", "stairs" } do
    local set = { radius = 0.001, blur = "contact" }
    local soft = render("volumes_blurred", { scene = scene, size = { 128, 128 }, visibility = true, set = set })
    set.blur = "none"
    local hard = render("volumes_blurred", { scene = scene, size = { 128, 128 }, visibility = true, set = set })
    expect(soft:difference(hard, 127).differing == 0, scene)
    expect(soft:difference(hard).rmse < 0.02, scene .. ": " .. soft:difference(hard).rmse)
  end
end)

test("the_error_against_rays_is_less_than_half_of_the_hard_shadow_s", function()
  for _, scene in ipairs{ "table", "room", "stairs", "cube" } do
    local function picture(recipe, set)
      return render(recipe, { scene = scene, size = { 128, 128 }, visibility = true, set = set })
    end
    local truth = picture("truth", { radius = 0.3, samples = 128 })
    local hard = picture("volumes_blurred", { radius = 0.3, blur = "none" }):difference(truth).rmse
    local soft = picture("volumes_blurred", { radius = 0.3, blur = "contact" }):difference(truth).rmse
    expect(soft < hard / 2, scene .. ": " .. soft .. " against " .. hard)
  end
end)
