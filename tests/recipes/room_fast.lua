-- The fast way to draw the lab's room against the lecture's, and its number of points against rays.
local size = 96
local world = scene.load "room"

local function draw(recipe, set, visibility, name)
  return render(recipe, { size = { size, size }, set = set, visibility = visibility, scene = name })
end

local function with(set, more)
  local all = {}
  for name, value in pairs(set) do all[name] = value end
  for name, value in pairs(more) do all[name] = value end
  return all
end

local cases = {
  ["as it is"] = {},
  ["hard"] = { soft = false },
  ["a large square light"] = { radius = 0.4, shape = "square", pattern = "jitter", jitters = 7, seed = 5 },
  ["turned"] = { turn = 70 },
  ["the light in the torus"] = { light = vec3(0.95, 1.05, -0.1), radius = 0.05 },
  ["the light below the casters"] = { light = vec3(-0.2, 0.2, 0.4), jitters = 4 },
  ["the light out of the room"] = { light = vec3(-3.5, 4, 3), radius = 0.5, jitters = 4 },
  ["the floor alone"] = { walls = false, jitters = 4 },
}

-- The casters' triangles meet edge to edge, and their silhouette is between the same corners: so a pixel is
-- hidden in both ways or in neither. Of pixels through whose centre an edge goes a few may be counted twice
-- or not at all by triangles that GL's rounding of their corners turns over.
test("the_same_points_hide_the_same_pixels", function()
  for name, set in pairs(cases) do
    local exact = with(set, { storage = "float32" })
    local off = draw("room", exact, true):difference(draw("room_fast", exact, true), 1)
    expect(off.differing <= 2, name .. ": " .. off.differing .. " pixels differ")
  end
end)

-- Shaded once, by the light's centre, where the lecture averages the shading of each point: of second order
-- in the light's radius over its distance, which is at most 1/7 here; 1/255 is the least step of the picture.
test("the_picture_is_the_lecture_s", function()
  for name, set in pairs(cases) do
    if name ~= "the light in the torus" and name ~= "a large square light" then
      local off = draw("room", set):difference(draw("room_fast", set), 3)
      expect(off.rmse < 1 / 255, name .. ": " .. off.rmse * 255 .. "/255")
    end
  end
end)

-- 300 shells, each in the next: more than 7 bits count, so their faces are drawn in parts.
test("casters_of_more_layers_than_7_bits_count_hide_a_pixel_once", function()
  -- So large a light that one of two points sees what all shells hide from the other.
  local set = { light = vec3(3.2, 4.4, 2.2), jitters = 2, radius = 2, storage = "float32" }
  local lecture, fast = draw("room", set, true, "shells"), draw("room_fast", set, true, "shells")
  local dark = 0
  for y = 0, size - 1 do
    for x = 0, size - 1 do
      if fast:color(x, y) < 255 then dark = dark + 1 end
    end
  end
  expect(dark > 50, "hardly a shadow")
  expect(lecture:difference(fast, 1).differing <= 2)
end)

test("walls_and_casters_that_cannot_meet_are_skipped", function()
  local light, teapot = world.lights[1], world:object "teapot"
  expect_equal(#shadow.outlines(teapot, nil, light, world:object "ceiling"), 0, "it is below the light")
  expect_equal(#shadow.outlines(teapot, nil, light, world:object "right wall"), 0, "it is on the other side")
  expect_equal(#shadow.outlines(teapot, nil, light, world:object "floor"), 1)
end)

test("an_outline_has_a_fraction_of_the_triangles", function()
  local torus = world:object "torus"
  local light, floor = world.lights[1], world:object "floor"
  local outline = shadow.outlines(torus, nil, light, floor)[1]
  expect(outline.triangles < torus.mesh.triangles / 10, outline.triangles .. " triangles")
  -- Two loops, of which a point within the tube's shadow is inside one more than of the other.
  expect(outline.layers >= 1 and outline.layers < 10, outline.layers .. " layers")
  local within = torus.model:transform_point(vec3(0, 0, 0))
  -- In its hole the filling may be on either side of the light: then it counts the same number too few everywhere.
  local around = shadow.outlines(torus, nil, vec4(within, 1), floor)[1]
  expect(around.triangles < torus.mesh.triangles / 10, around.triangles .. " triangles with the light in its box")
  expect_equal(outline.offset, 0)
  expect(around.offset ~= 0, "nothing is missing")
end)

test("receivers_that_are_not_planar_are_refused", function()
  local other = scene.load "table"
  expect_error(function() shadow.outlines(other.casters[1], nil, vec4(0, 9, 0, 1), other.casters[1]) end, "not planar")
end)

-- How many points a picture of the adaptive way took, by the name of its last estimate.
local function points_of(picture)
  local points
  for _, name in ipairs(picture.passes) do points = tonumber(name:match "^what (%d+) points") or points end
  return points
end

-- Over the picture, as the recipe's estimate is; pixels without a wall have no error.
local function error_of(picture, truth)
  local squares = 0
  for y = 0, size - 1 do
    for x = 0, size - 1 do
      if picture:depth(x, y) < 1 then
        squares = squares + (((picture:color(x, y)) - (truth:color(x, y))) / 255) ^ 2
      end
    end
  end
  return math.sqrt(squares) / size
end

test("points_grow_until_the_error_asked_for_is_met", function()
  local bare = { radius = 0.3, tessellation = 1 }
  local last = 0
  for _, asked in ipairs{ 0.02, 0.01, 0.005 } do
    local picture = draw("room_fast", with(bare, { error = asked }), true)
    local most = draw("room_fast", with(bare, { jitters = 1024, pattern = "owen", seed = 9 }), true)
    local points = points_of(picture)
    expect(error_of(picture, most) <= asked, points .. " points: " .. error_of(picture, most))
    expect(points >= last, points .. " points for " .. asked .. ", " .. last .. " for more")
    last = points
  end
  expect(last > 16)
end)

test("a_light_that_is_small_in_the_picture_takes_few_points", function()
  local small = points_of(draw("room_fast", { error = 0.005, radius = 0.01 }))
  local large = points_of(draw("room_fast", { error = 0.005, radius = 0.4 }))
  expect(small == 16, small .. " points: two halves of eight are the least that is looked at")
  expect(large >= 4 * small, large .. " points")
end)

test("no_more_points_are_spent_than_allowed", function()
  expect_equal(points_of(draw("room_fast", { error = 1e-9, most = 32 })), 32)
end)
