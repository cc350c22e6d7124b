-- The lab's room against rays, against the shading computed at its vertices, and against itself.
local analytic = require "analytic"

local size = 64
local world = scene.load "room"
local lamp = world.lights[1]

local function room(set, visibility)
  return render("room", { size = { size, size }, set = set, visibility = visibility })
end

-- Calls visit(x, y, wall, point, viewer) for the pixels that show a wall, and no caster before it.
local function each_wall_pixel(picture, visit)
  local viewer = analytic.viewer(world.camera, size, size)
  local visited = 0
  for y = 0, size - 1 do
    for x = 0, size - 1 do
      local shown, at
      for _, wall in ipairs(world.receivers) do
        local point = analytic.on_plane(viewer, wall.plane, x, y)
        if point then
          local _, depth = analytic.window(viewer, point)
          -- 24 bits of depth; walls that meet are farther apart but for the pixels of their edge.
          if math.abs(depth - picture:depth(x, y)) < 1e-6 then shown, at = wall, point end
        end
      end
      if shown then
        visited = visited + 1
        visit(x, y, shown, at, viewer)
      end
    end
  end
  expect(visited > size * size / 2, "hardly a pixel is compared")
end

local function error_of(picture, truth)
  local squares, count = 0, 0
  each_wall_pixel(picture, function(x, y)
    count = count + 1
    squares = squares + (((picture:color(x, y)) - (truth:color(x, y))) / 255) ^ 2
  end)
  return math.sqrt(squares / count)
end

local function traced(radius)
  return render("truth", { scene = "room", size = { size, size }, visibility = true,
                           set = { radius = radius, samples = 64 } })
end

test("hard_shadows_on_the_walls_are_those_of_rays", function()
  -- Pixels whose centre is on a shadow's edge to a 256th of a pixel may fall to either side: of some
  -- 400 along the edges, two at most.
  expect(error_of(room({ soft = false }, true), traced(0)) < math.sqrt(2 / (size * size / 2)))
end)

test("soft_shadows_near_those_of_rays_as_jitters_grow", function()
  local truth, last = traced(0.12), math.huge
  for _, jitters in ipairs{ 1, 4, 16 } do
    local off = error_of(room({ jitters = jitters, radius = 0.12 }, true), truth)
    -- As random points would do on average: half the error for four times the points.
    expect(off < 0.6 * last, jitters .. " jitters: " .. off .. " after " .. last)
    last = off
  end
end)

test("a_soft_frame_is_the_average_of_hard_ones", function()
  local set = { jitters = 4, radius = 0.3, shape = "square", pattern = "jitter", seed = 5, storage = "float32" }
  local soft, hard = room(set), {}
  local light = { center = lamp.xyz, u = vec3(0.3, 0, 0), v = vec3(0, 0, 0.3) }
  for i, point in ipairs(shadow.samples(light, 4, "jitter", 5)) do
    hard[i] = room{ soft = false, light = string.format("%.17g,%.17g,%.17g", point.x, point.y, point.z) }
  end
  for y = 0, size - 1 do
    for x = 0, size - 1 do
      local sum = vec3(0)
      for i = 1, 4 do sum = sum + analytic.rgb(hard[i], x, y) end
      expect_near(analytic.rgb(soft, x, y), sum / 4, 0.501, "rounded to 8 bits once")
    end
  end
end)

-- With a quad for the floor its colours come from four vertices, whatever the light does above it.
test("lighting_is_per_vertex", function()
  local picture = room{ soft = false, tessellation = 1 }
  local floor = world:object "floor"
  local sheet = mesh.plane(4, 4, 1, 1)
  local compared = 0
  each_wall_pixel(picture, function(x, y, wall, point, viewer)
    if wall.name ~= "floor" then return end
    for t = 0, sheet.triangles - 1 do
      local corners, colors = {}, {}
      for i, index in ipairs{ sheet:triangle(t) } do
        corners[i] = sheet:position(index)
        colors[i] = analytic.phong(viewer, corners[i], vec3(0, 1, 0), lamp, floor.color, 0.25)
      end
      local edges = mat3(vec3(corners[1].x, corners[1].z, 1), vec3(corners[2].x, corners[2].z, 1),
                         vec3(corners[3].x, corners[3].z, 1)):inverse()
      local weights = edges * vec3(point.x, point.z, 1)
      if weights.x > 0.01 and weights.y > 0.01 and weights.z > 0.01 then
        local lit = colors[1] * weights.x + colors[2] * weights.y + colors[3] * weights.z
        local got, dark = analytic.rgb(picture, x, y), analytic.levels(floor.color * 0.25)
        if got ~= dark then
          compared = compared + 1
          expect_near(got, analytic.levels(lit), 1, "interpolated in float")
        end
      end
    end
  end)
  expect(compared > 150, "hardly a pixel is lit")
end)

-- How many pixels are so.
local function count(picture, what)
  local found = 0
  for y = 0, size - 1 do
    for x = 0, size - 1 do
      if what(analytic.rgb(picture, x, y), picture:depth(x, y)) then found = found + 1 end
    end
  end
  return found
end

test("the_stencil_keeps_shadows_on_the_floor", function()
  local shadow_color = analytic.levels(world:object("floor").color * 0.25)
  local function shadows(clip)
    return count(room{ soft = false, walls = false, clip = clip }, function(color) return color == shadow_color end)
  end
  local clipped, free = shadows(true), shadows(false)
  expect(free > clipped * 1.1, clipped .. " pixels clipped, " .. free .. " not")
  local background = analytic.levels(vec3(0.10, 0.11, 0.14))
  local picture = room{ soft = false, walls = false }
  local viewer = analytic.viewer(world.camera, size, size)
  for y = 0, size - 1 do
    for x = 0, size - 1 do
      local point = analytic.on_plane(viewer, vec4(0, 1, 0, 0), x, y)
      local outside = not point or math.abs(point.x) > 2.06 or math.abs(point.z) > 2.06
      if outside and picture:depth(x, y) == 1 then
        expect_equal(analytic.rgb(picture, x, y), background, x .. ", " .. y)
      end
    end
  end
end)

-- What reaches beyond a wall is behind the others, or out of the room's open side.
test("inside_the_room_clipping_changes_nothing_but_edges", function()
  local clipped, free = room({ soft = false }, true), room({ soft = false, clip = false }, true)
  local differing = 0
  each_wall_pixel(clipped, function(x, y)
    if clipped:color(x, y) ~= free:color(x, y) then differing = differing + 1 end
  end)
  -- Of the pixels where two walls meet, a quarter of the picture's width at most.
  expect(differing < size / 4, differing .. " pixels")
end)

test("the_orb_grows_when_the_walls_are_hidden", function()
  local function shining(walls)
    return count(room{ soft = false, walls = walls }, function(color) return color.r == 255 and color.g == 242 end)
  end
  local small, large = shining(true), shining(false)
  expect(small >= 1 and large > 15 * small, small .. " pixels, then " .. large)  -- (0.2 / 0.04)^2 = 25
end)

test("every_key_of_the_lab_does_something", function()
  local recipe = require "room"
  for key in ("hjklbfrsxc[];'-+"):gmatch "." do
    local action = recipe.keys[key]
    expect(action, "no key " .. key)
    local verb, name = action:match "^(%a+) (%a+)"
    expect(verb == "add" or verb == "multiply" or verb == "toggle", key)
    expect(recipe.params[name], key .. ": there is no parameter " .. name)
  end
end)

test("turning_moves_the_casters_and_their_shadows", function()
  local still, turned = room({ soft = false }, true), room({ soft = false, turn = 90 }, true)
  expect(still:difference(turned, 127).differing > 20)
end)
