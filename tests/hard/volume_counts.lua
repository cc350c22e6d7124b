-- How many volumes hold a point: more than a stencil counts, and counted from inside of them.
local analytic = require "analytic"
local given = require "given"
local listing = require "listing"

-- Boxes one in another around (0, 1, 0), the outermost 2 wide.
local function nest(count)
  local boxes = {}
  for i = 1, count do
    boxes[i] = mesh.box(2 - 1.6 * (i - 1) / count):transformed(mat4.translate(0, 1.2, 0))
  end
  return boxes
end

local function casters_of(meshes)
  local objects = { given.floor() }
  for i, one in ipairs(meshes) do objects[i + 1] = given.caster("box " .. i, one) end
  return objects
end

local light = vec4(3.2, 3.2, 0.6, 1)

-- ---- 11: more than a stencil counts

test("eight_bits_that_count_300_volumes_at_once_say_44_and_256_say_none", function()
  for count, stencil in pairs{ [255] = 255, [256] = 0, [300] = 44 } do
    local world = given.world_of(casters_of{ given.joined(nest(count)) })
    local picture = listing.volumes(world, light, "zfail")
    -- The middle of the innermost's shadow.
    local behind = analytic.cast(vec4(0, 1, 0, 0), light, vec3(0, 1.2, 0))
    local pixel = analytic.window(analytic.viewer(scene.load("given").camera, given.size, given.size), behind)
    expect_equal(picture:stencil(pixel.x // 1, pixel.y // 1), stencil)
    if count == 256 then
      naive("all bits count at once: 256 volumes leave 0, 300 leave 44", picture)
      ours("256 boxes, one in another: the truth", given.draw("volumes_zfail", world, light))
    end
  end
end)

test("nested_casters_of_any_number_are_the_truth_as_objects_and_as_one_mesh", function()
  local truth
  for _, count in ipairs{ 1, 127, 128, 129, 254, 255, 256, 257, 300 } do
    local world = given.world_of(casters_of{ given.joined(nest(count)) })
    -- What the outermost hides is not seen, so that the truth does not change.
    truth = truth or given.draw("truth", world, light)
    given.expect_same(given.draw("volumes_zfail", world, light), truth, count .. " in one mesh")
  end
  local world = given.world_of(casters_of(nest(256)))
  given.expect_truth(world, light, "256 objects")
end)

test("300_shells_leave_everything_inside_of_them_in_shadow", function()
  local size = { given.size, given.size }
  local truth = render("truth", { scene = "shells", size = size })
  for _, recipe in ipairs{ "volumes_zfail", "volumes_auto" } do
    local picture = render(recipe, { scene = "shells", size = size })
    given.expect_same(picture, truth, recipe)
    if recipe == "volumes_auto" then ours("inside of 300 shells too, in parts of at most 127 layers", picture) end
  end
end)

-- Triangles of one component, in layers: a stair-cased surface that a component's own count splits.
test("one_component_that_a_ray_crosses_300_times_is_the_truth", function()
  local cells = require "parts.cells"
  local xs, ys = { -1, -0.8, 0.8, 1 }, {}
  for i = 0, 600 do ys[i + 1] = 0.2 + 1.6 * i / 600 end
  -- A comb of 300 shelves on two posts at its ends.
  local shelves = cells(xs, ys, { -0.8, 0.8 }, function(x, y) return x ~= 2 or y % 2 == 1 end)
  local world = given.world_of{ given.floor(), given.caster("shelves", shelves) }
  given.world = world
  expect(#shadow.parts(scene.load("given").casters[1], nil, light) > 1)
  given.expect_truth(world, light)
  -- From this light each pixel holds a dozen edges of shelves' shadows, and each of them may move by 1/256
  -- of the pixel.
  given.expect_truth(world, vec4(0.3, 1, 0.2, 0), "", 256 // 12)
end)

test("parts_are_as_many_as_layers_need_and_others_are_refused", function()
  given.world = given.world_of(casters_of{ given.joined(nest(300)), mesh.box(1) })
  local here = scene.load "given"
  local many, one = shadow.parts(here.casters[1], nil, light), shadow.parts(here.casters[2], nil, light)
  expect_equal(#one, 1)
  expect_equal(one[1], 1)
  expect(#many >= 3, "300 layers in " .. #many .. " parts")
  local triangles = 0
  for part, layers in ipairs(many) do
    expect(layers <= 127, "part " .. part .. " has " .. layers)
    triangles = triangles + shadow.volume(here.casters[1], nil, light, { part = part }).triangles
  end
  -- Where a box is cut in two each half has sides along the cut.
  expect(triangles >= shadow.volume(here.casters[1], nil, light).triangles)
  expect_error(function() shadow.volume(here.casters[2], nil, light, { part = 2 }) end,
               "there is no part 2; for this light there is one")
  expect_error(function() shadow.volume(here.casters[1], nil, light, { part = 1000 }) end, "there is no part 1000")
  expect_error(function() shadow.volume(here.casters[2], nil, light, { part = 0.5 }) end, "part is a number from 1")
end)

-- ---- 12: the camera inside of volumes

-- Boards over the eye, which looks at what is below them.
local function boards(count)
  local objects = { given.floor(), given.caster("ball", mesh.sphere(0.4, 20, 12), mat4.translate(0.8, 0.6, -0.5)) }
  for i = 1, count do
    objects[#objects + 1] = given.caster("board " .. i, mesh.box(3, 0.1, 3), mat4.translate(0, 3 + 0.3 * i, 2))
  end
  return objects
end
local under = { eye = vec3(0, 1.2, 2.4), target = vec3(0.2, 0.7, -1), fovy = 70, near = 0.2, far = 60 }
local above = vec4(0.2, 9, 2, 1)

test("from_inside_of_volumes_z_fail_is_the_truth_and_z_pass_is_off_by_their_number", function()
  for _, count in ipairs{ 1, 3 } do
    local world = given.world_of(boards(count), under)
    given.expect_truth(world, above, count .. " boards,")
    local fail = given.draw("volumes_zfail", world, above)
    local pass = given.draw("volumes_zpass", world, above)
    local two_sided = given.draw("volumes_two_sided", world, above)
    for y = 0, given.size - 1 do
      for x = 0, given.size - 1 do
        -- All of the near plane is in the same volumes: bits 0 to 6 are off by them, everywhere.
        expect_equal((fail:stencil(x, y) - pass:stencil(x, y)) % 128, count, x .. ", " .. y)
        expect_equal(pass:stencil(x, y), two_sided:stencil(x, y))
      end
    end
    expect(given.differing(pass, fail) > 1000, "z-pass looks right")
    if count == 3 then
      naive("z-pass is off by 3 in every pixel", pass)
      ours("z-fail and auto are the truth", fail)
    end
  end
end)

test("from_outside_z_pass_is_z_fail", function()
  local world = given.world_of(boards(3))
  local fail = given.draw("volumes_zfail", world, above)
  for _, recipe in ipairs{ "volumes_zpass", "volumes_two_sided", "volumes_auto" } do
    expect_equal(fail:difference(given.draw(recipe, world, above)).stencil, 0, recipe)
  end
end)

-- ---- 13: the near plane cuts a volume

test("where_the_near_plane_cuts_a_volume_z_fail_and_auto_are_the_truth_and_z_pass_is_not", function()
  local seen_wrong = 0
  for step = 0, 4 do
    local camera = { eye = vec3(1.5 + 0.2 * step, 1.6, 3), target = vec3(0.2, 0.7, -1), fovy = 60,
                     near = 0.4, far = 60 }
    local world = given.world_of(boards(1), camera)
    given.expect_truth(world, vec4(0.2, 9, 2.6, 1), "step " .. step)
    local off = given.differing(given.draw("volumes_zpass", world, vec4(0.2, 9, 2.6, 1)),
                                given.draw("volumes_zfail", world, vec4(0.2, 9, 2.6, 1)))
    if off > 100 then
      seen_wrong = seen_wrong + 1
      if seen_wrong == 1 then
        naive("z-pass: " .. off .. " pixels are wrong", given.draw("volumes_zpass", world, vec4(0.2, 9, 2.6, 1)))
        ours("z-fail and auto are the truth", given.draw("volumes_auto", world, vec4(0.2, 9, 2.6, 1)))
      end
    end
  end
  expect(seen_wrong > 0, "the near plane cuts no volume")
end)

test("a_caster_that_the_near_plane_cuts_open_is_the_truth", function()
  local box = given.caster("box", mesh.box(1.6), mat4.translate(0, 1, 0) * mat4.rotate(30, 0, 1, 0))
  for _, near in ipairs{ 2.2, 2.6, 3.0 } do
    local camera = { eye = vec3(0.3, 1.8, 3), target = vec3(0, 0.8, 0), fovy = 60, near = near, far = 60 }
    given.expect_truth(given.world_of({ given.floor(), box }, camera), light, "near " .. near)
  end
end)

row{ case = 11, title = "300 nested casters, and exactly 256", expected = "everything inside is in shadow, with 8 stencil bits",
     facts = { "eight_bits_that_count_300_volumes_at_once_say_44_and_256_say_none",
               "nested_casters_of_any_number_are_the_truth_as_objects_and_as_one_mesh",
               "300_shells_leave_everything_inside_of_them_in_shadow", "one_component_that_a_ray_crosses_300_times_is_the_truth",
               "parts_are_as_many_as_layers_need_and_others_are_refused" } }
row{ case = 12, title = "The camera inside a volume", expected = "z-fail is the truth; plain z-pass is off by a constant",
     facts = { "from_inside_of_volumes_z_fail_is_the_truth_and_z_pass_is_off_by_their_number", "from_outside_z_pass_is_z_fail" } }
row{ case = 13, title = "The near plane cutting a volume", expected = "z-fail and the automatic choice are the truth",
     facts = { "where_the_near_plane_cuts_a_volume_z_fail_and_auto_are_the_truth_and_z_pass_is_not",
               "a_caster_that_the_near_plane_cuts_open_is_the_truth" } }
