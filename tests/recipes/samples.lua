-- shadow.samples: points on lights of each shape, in each pattern.
local patterns = { "random", "jitter", "grid", "hammersley", "r2", "sobol", "owen" }
local center, u, v = vec3(1, 2, 3), vec3(0.5, 0, 0.2), vec3(0, 0.1, 0.4)

-- A point in the coordinates of the half axes, and its distance from their plane.
local function within(point)
  local axes = mat3(u, v, u:cross(v):normalize()):inverse()
  return axes * (point.xyz - center)
end

test("a_rectangle_s_points_are_within_its_half_axes", function()
  for _, pattern in ipairs(patterns) do
    for _, point in ipairs(shadow.samples({ center = center, u = u, v = v }, 37, pattern)) do
      local at = within(point)
      expect_equal(point.w, 1)
      expect(math.abs(at.x) <= 1 and math.abs(at.y) <= 1, pattern)
      expect_near(at.z, 0, 1e-14, "an inverse and a product in double")
    end
  end
end)

test("a_disk_s_points_are_within_its_ellipse", function()
  for _, pattern in ipairs(patterns) do
    for _, point in ipairs(shadow.samples({ center = center, u = u, v = v, disk = true }, 37, pattern)) do
      expect(within(point).xy:length() <= 1 + 1e-14, pattern)
    end
  end
end)

test("a_sphere_s_points_are_on_it", function()
  for _, pattern in ipairs(patterns) do
    for _, point in ipairs(shadow.samples({ center = center, radius = 0.3 }, 37, pattern)) do
      expect_near((point.xyz - center):length(), 0.3, 1e-15, "rounding of a length")
    end
  end
end)

test("the_centroid_of_a_grid_is_the_centre", function()
  local sum = vec3(0)
  local points = shadow.samples({ center = center, u = u, v = v }, 16, "grid")
  expect_equal(#points, 16)
  for _, point in ipairs(points) do sum = sum + point.xyz end
  expect_near(sum / 16, center, 1e-14, "16 sums in double")
end)

test("nested_patterns_begin_with_the_points_of_fewer", function()
  for _, pattern in ipairs{ "random", "r2", "sobol", "owen" } do
    local few = shadow.samples({ center = center, radius = 1 }, 5, pattern, 7)
    local many = shadow.samples({ center = center, radius = 1 }, 64, pattern, 7)
    for i, point in ipairs(few) do expect_equal(point, many[i], pattern) end
  end
end)

test("a_seed_moves_the_seeded_patterns_alone", function()
  for _, pattern in ipairs(patterns) do
    local one = shadow.samples({ center = center, radius = 1 }, 4, pattern, 1)
    local two = shadow.samples({ center = center, radius = 1 }, 4, pattern, 2)
    local seeded = pattern == "random" or pattern == "jitter" or pattern == "owen"
    expect_equal(one[1] == two[1], not seeded, pattern)
  end
end)

test("more_points_are_needed_for_a_larger_penumbra_and_a_smaller_error", function()
  local world = scene.load "plate"
  local lamp = { center = vec3(0.2, 3, 0.1), u = vec3(0.4, 0, 0), v = vec3(0, 0, 0.4) }
  local n, penumbra = shadow.samples_needed(world, world.camera, lamp, 0.01)
  local more, wider = shadow.samples_needed(world, world.camera, { center = lamp.center, u = lamp.u * 2, v = lamp.v * 2 }, 0.01)
  expect(more > n and wider.width > 1.9 * penumbra.width and wider.share > penumbra.share)
  expect(shadow.samples_needed(world, world.camera, lamp, 0.001) > n)
  expect_equal(shadow.samples_needed(world, world.camera, vec4(0.2, 3, 0.1, 1), 0.001), 1, "a point has no penumbra")
  expect_error(function() shadow.samples_needed(world, world.camera, lamp, 0) end, "over 0")
end)

test("a_point_gives_itself", function()
  for _, point in ipairs(shadow.samples(vec4(2, 4, 1, 1), 3)) do expect_equal(point, vec4(2, 4, 1, 1)) end
end)

test("wrong_lights_patterns_and_numbers_are_refused", function()
  local light = { center = center, radius = 1 }
  expect_error(function() shadow.samples(light, 0) end, "from 1 to 65536")
  expect_error(function() shadow.samples(light, 1.5) end, "whole number")
  expect_error(function() shadow.samples(light, 4, "jiter") end, "did you mean jitter?")
  expect_error(function() shadow.samples(light, 4, 3) end, "a pattern is a name")
  expect_error(function() shadow.samples(light, 4, "owen", -1) end, "not negative")
  expect_error(function() shadow.samples(vec4(0, 1, 0, 0), 4) end, "infinity")
end)
