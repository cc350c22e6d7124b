-- What the search for departures found (`shadowlab stress --search`), each made as simple as it could be: where a
-- technique was wrong and is mended, and where it is wrong by its nature, with the bound that it is documented by.
local found = require "found"
local given = require "given"
local listing = require "listing"

local beyond = given.beyond

local volumes = { "volumes_zfail", "volumes_auto", "volumes_two_sided", "planned" }

-- ---- 31: a light in a face

local in_a_face = {
  size = { 64, 64 }, light = vec4(-0.6275255158543587, 0.8000000044703484, -1.3207106813788414, 1),
  camera = { eye = vec3(0, 1.5, 0.25), target = vec3(0, 0, 0), fovy = 163.80552396168758, near = 0.01, far = 60 },
  { mesh.tetrahedron(0.6), "none", vec3(-0.75, 0.75, -1.25), vec3(0, 1, 0), 90, vec3(0.75, 0.75, 0.75) } }

test("a_light_in_a_face_draws_what_it_does_a_hair_beside_it", function()
  found.at_its_size(in_a_face, function(world, light)
    given.world = world
    local caster = scene.load("given").casters[1]
    for t = 0, 3 do
      local corners = { caster.mesh:triangle(t) }
      for i, corner in ipairs(corners) do corners[i] = caster.model:transform_point(caster.mesh:position(corner)) end
      local a, b, c = table.unpack(corners)
      local normal, middle = (b - a):cross(c - a):normalize(), (a + b + c) / 3
      -- It is moved off by 2^-17 of the mesh's radius, to one of its sides.
      local front = given.draw("truth", world, vec4(middle + normal * 4e-6, 1))
      local back = given.draw("truth", world, vec4(middle - normal * 4e-6, 1))
      for _, recipe in ipairs{ "volumes_zfail", "planned" } do
        local picture = given.draw(recipe, world, vec4(middle, 1))
        local wrong = math.min(beyond(picture, front), beyond(picture, back))
        expect_equal(wrong, 0, recipe .. ", face " .. t)
        if t == 2 and recipe == "volumes_zfail" then ours("what the light throws a hair beside the face", picture) end
      end
    end
    local truth = given.draw("truth", world, light)
    local picture = listing.prisms(world, light, 1000)
    local wrong = beyond(picture, truth)
    expect(wrong > 100, wrong)
    naive("lit faces extruded by 1000: " .. wrong .. " pixels are wrong, of half the world that should be dark", picture)
  end)
end)

-- ---- 32: a side that rounding turns round

local turned_round = {
  size = { 64, 64 }, light = vec4(-544, -387, -279, 1),
  camera = { eye = vec3(-1, 1, 0), target = vec3(1, 1, 1), fovy = 125.11337615551321, near = 0.01, far = 60 },
  { mesh.sphere(0.5, 12, 7), "needles", vec3(-1, 0, 0), vec3(0, 1, 0), 0, vec3(1, 1, 1) } }

test("a_side_that_rounding_turns_round_is_counted_where_no_face_is_culled", function()
  found.at_its_size(turned_round, function(world, light)
    local truth = given.draw("truth", world, light)
    local one, culled = given.draw("volumes_two_sided", world, light), given.draw("volumes_zpass", world, light)
    expect_equal(beyond(one, truth), 0)
    expect_equal(one:difference(given.draw("volumes_auto", world, light)).stencil, 0)
    ours("one draw, whose every pixel is a front or a back: the truth", one)
    local lost = one:difference(culled).stencil
    expect(lost > 0)
    naive("two draws with culled faces: a count is lost in " .. lost .. " pixel", culled)
  end)
end)

-- ---- 33: a near plane of a hundred-thousandth

local near_plane = {
  size = { 64, 64 }, light = vec4(0, 5, 2, 1),
  camera = { eye = vec3(0, 1, 2), target = vec3(0, 0, 0), fovy = 60, near = 1.019747315609152e-05, far = 60 },
  { mesh.box(1), "none", vec3(0, 0, 0), vec3(1, 1, 0), 0, vec3(1, 1, 1) } }

test("a_near_plane_of_a_hundred_thousandth_errs_by_its_depth_s_steps_and_no_more", function()
  local analytic = require "analytic"
  found.at_its_size(near_plane, function(world, light)
    local truth = given.draw("truth", world, light)
    local viewer = analytic.viewer(scene.load("given").camera, given.size, given.size)
    local forward = (vec3(0, 0, 0) - viewer.eye):normalize()
    for _, recipe in ipairs(volumes) do
      local picture, wrong = given.draw(recipe, world, light), 0
      for y = 0, given.size - 1 do
        for x = 0, given.size - 1 do
          local off = (vec4(picture:color(x, y)) - vec4(truth:color(x, y))):abs()
          if math.max(off.x, off.y, off.z) > 3 then
            wrong = wrong + 1
            -- The box's front is z = 1/2, the floor y = 0; both are within twelve steps of the depth buffer.
            local front = analytic.on_plane(viewer, vec4(0, 0, 1, -0.5), x, y)
            local floor = analytic.on_plane(viewer, vec4(0, 1, 0, 0), x, y)
            local z = (front - viewer.eye):dot(forward)
            if front and math.abs(front.x) < 0.5 and front.y > 0 and front.y < 0.5 then
              expect((floor - viewer.eye):dot(forward) - z <= 12 * z * z / (near_plane.camera.near * 2 ^ 24),
                     recipe .. ": wrong at " .. x .. ", " .. y)
            end
          end
        end
      end
      if recipe == "volumes_zfail" then
        ours(wrong .. " pixels at the box's foot, within 12 z²/(n 2^24) = 0.3 m of it", picture)
      end
    end
  end)
end)

-- ---- 34: a light within its caster's bounds, and one map

local among = {
  size = { 64, 64 }, light = vec4(1.25, 1.25, 1, 1),
  camera = { eye = vec3(1, 2, 1), target = vec3(0, 1, 1), fovy = 12.047560692460241, near = 0.01, far = 60 },
  { mesh.box(1), "none", vec3(1.5, 1.5, 1), vec3(0, 0, -1), 0, vec3(1, 1, 1) } }

test("one_map_of_a_light_within_its_caster_tells_no_depths_and_volumes_do", function()
  found.at_its_size(among, function(world, light)
    local truth = given.draw("truth", world, light)
    for _, recipe in ipairs{ "volumes_zfail", "volumes_auto", "planned" } do
      expect_equal(beyond(given.draw(recipe, world, light), truth), 0, recipe)
    end
    ours("volumes: all of the world is dark", given.draw("volumes_zfail", world, light))
    local mapped = given.draw("shadow_map_sampler", world, light, { size = 1024, compare = "LEQUAL", bias = "offset" })
    expect(beyond(mapped, truth) > 0)
    naive("one map, near plane at 1e-5 of the far: " .. beyond(mapped, truth) .. " pixels are lit", mapped)
  end)
end)

-- ---- 35: a light in a sheet so narrow that all of it is at hand

local in_a_sliver = {
  size = { 64, 64 }, light = vec4(1.25, 0.125, 0, 1),
  camera = { eye = vec3(3, 1.5, 2), target = vec3(0, 0, 0), fovy = 60, near = 0.01, far = 60 },
  { mesh.plane(1, 1e-4), "none", vec3(1.25, 0.125, 0), vec3(0, 1, 0), 0, vec3(1, 1, 1) } }

-- Seen from so near the sheet hides nearly half the world, from above or from beneath; from within nothing.
test("a_light_in_a_narrow_sheet_throws_no_shadow_of_it", function()
  found.at_its_size(in_a_sliver, function(world, light)
    local truth = given.draw("truth", world, light)
    for _, recipe in ipairs{ "volumes_zfail", "volumes_auto", "planned" } do
      expect_equal(beyond(given.draw(recipe, world, light), truth), 0, recipe)
    end
    ours("no shadow", given.draw("volumes_zfail", world, light))
    expect_equal(beyond(listing.prisms(world, light, 1000), truth), 0)
  end)
end)

-- ---- 36: a caster thinner than a texel

local thin = {
  size = { 64, 64 }, light = vec4(2.25, 3.5, -2.25, 1),
  camera = { eye = vec3(-1, 4, -2), target = vec3(0, 0.75, 0), fovy = 105.39126138737191, near = 0.01, far = 60 },
  { mesh.plane(1, 1e-4), "none", vec3(-0.75, 0.75, -1.5), vec3(0, 1, 0), 0, vec3(1, 1, 1) } }

test("a_caster_thinner_than_a_texel_throws_a_texel_s_shadow_here_and_there", function()
  found.at_its_size(thin, function(world, light)
    local truth = given.draw("truth", world, light)
    for _, recipe in ipairs{ "volumes_zfail", "planned" } do
      expect_equal(beyond(given.draw(recipe, world, light), truth), 0, recipe)
    end
    ours("volumes: nothing wider than it is", given.draw("volumes_zfail", world, light))
    local mapped = given.draw("shadow_map_cube", world, light,
                              { size = 512, filter = "NEAREST", keep = false, cull = true })
    expect(beyond(mapped, truth) > 0)
    naive("a cube of 512² texels: " .. beyond(mapped, truth) .. " pixels of dashes", mapped)
  end)
end)

-- ---- 37: a shadow narrower than what a rasterizer tells

local narrow = {
  size = { 64, 64 }, light = vec4(2, 3, -0.25, 1),
  camera = { eye = vec3(0.25, 1.5, 4.25), target = vec3(0, 0.75, 0), fovy = 32.11999281369272, near = 1, far = 60 },
  { mesh.plane(1, 1e-4), "none", vec3(-1, 0.25, 0.25), vec3(0, 1, 0), 0, vec3(1, 1, 1) } }

test("a_shadow_narrower_than_a_hundredth_of_a_pixel_comes_and_goes_by_single_pixels", function()
  found.at_its_size(narrow, function(world, light)
    local truth, without = given.draw("truth", world, light), { floor = world.objects[1] }
    local bare = given.draw("truth", given.world_of({ without.floor }, world.camera), light)
    -- 1e-4 of the floor's 0.04 a pixel: of the hundred pixels that the shadow crosses one shows it at a time.
    for _, recipe in ipairs(volumes) do
      expect(given.differing(given.draw(recipe, world, light), bare) <= 3, recipe)
    end
    ours("at most three pixels of a hundred, as in the truth", given.draw("volumes_zfail", world, light))
    expect(given.differing(truth, bare) <= 3)
  end)
end)

-- ---- 38: moments of depths from far away

local far_away = {
  size = { 64, 64 }, light = vec4(36842, 42536, 17391, 1),
  camera = { eye = vec3(4, 2, -3), target = vec3(-1, 1, 0), fovy = 60, near = 0.01, far = 60 },
  { mesh.box(1), "none", vec3(-1, 1, -1), vec3(1, 1, 0), 0, vec3(1, 1, 1) } }

test("a_light_sixty_thousand_units_away_leaves_volumes_as_they_are_and_moments_rough", function()
  found.at_its_size(far_away, function(world, light)
    local truth = given.draw("truth", world, light)
    for _, recipe in ipairs(volumes) do
      expect_equal(beyond(given.draw(recipe, world, light), truth), 0, recipe)
    end
    ours("the truth, as for a direction", given.draw("volumes_zfail", world, light))
    local moments = given.draw("shadow_map_moments", world, light, { size = 1024, reach = 2, kind = "variance" })
    naive(beyond(moments, truth) .. " pixels of a map of moments are beside the truth by more than shading", moments)
  end)
end)

-- ---- 39: a surface that the light grazes

local grazed = {
  size = { 64, 64 }, light = vec4(2, 1, 1, 1),
  camera = { eye = vec3(1, 3, 3), target = vec3(0, 0.5, 0), fovy = 60, near = 0.1, far = 60 },
  { mesh.box(1), "none", vec3(0, 0.5, 0), vec3(0, 1, 0), 0, vec3(1, 1, 1) } }

test("a_surface_that_the_light_grazes_looks_the_same_lit_and_dark", function()
  found.at_its_size(grazed, function(world, light)
    local truth = given.draw("truth", world, light)
    for _, recipe in ipairs(volumes) do
      given.expect_same(given.draw(recipe, world, light), truth, recipe)
      for _, off in ipairs{ 1e-6, -1e-6 } do
        given.expect_same(given.draw(recipe, world, light + vec4(0, off, 0, 0)), truth, recipe .. ", off by " .. off)
      end
    end
    ours("the box's top has a cosine of 0: lit or dark, it is the same", given.draw("volumes_zfail", world, light))
  end)
end)

-- ---- 40: z-fail and z-pass where depth tells hardly anything

test("z_fail_and_z_pass_draw_the_same_where_depth_tells_hardly_anything", function()
  found.at_its_size(near_plane, function(world, light)
    local one = given.draw("volumes_zfail", world, light)
    for _, recipe in ipairs{ "volumes_zpass", "volumes_two_sided", "volumes_auto", "planned" } do
      expect_equal(given.draw(recipe, world, light):difference(one).differing, 0, recipe)
    end
    ours("by z-fail and by z-pass pixel for pixel the same", one)
    -- What hides a caster hides its cap: a cap that is not moved with its caster is counted beside it.
    local differing = listing.volumes(world, light, "zfail"):difference(listing.volumes(world, light, "zpass")).differing
    expect(differing <= 2, differing)
  end)
end)

-- ---- 41: a light eight hundred thousand units away in a world of a million

local far_and_large = {
  unit = 1000000, size = { 64, 64 }, light = vec4(-5573, 771550, 324723, 1),
  camera = { eye = vec3(-2, 3, 1), target = vec3(0, 1, 0), fovy = 60, near = 0.01, far = 60 },
  { mesh.box(1), "none", vec3(0, 2, 1), vec3(0, 1, 0), 0, vec3(1, 1, 1) } }

-- Squares of a clip coordinate are 1e24 there, and products of those no floats any more: what is not a
-- number is not nearer than the map, and all was dark.
test("a_light_far_from_a_large_world_lights_it_by_maps_too", function()
  found.at_its_size(far_and_large, function(world, light)
    local truth = given.draw("truth", world, light)
    for recipe, params in pairs{ fbo = { bias = "offset" }, copy = { bias = "recommended" },
                                 sampler = { bias = "offset", compare = "LEQUAL" } } do
      params.size = 512
      local picture = given.draw("shadow_map_" .. recipe, world, light, params)
      expect_equal(beyond(picture, truth), 0, recipe)
      if recipe == "fbo" then ours("no wrong pixel", picture) end
    end
  end)
end)

-- From a light as far as this a float tells places by centimetres: what asks "is it as near as depth can tell?"
-- must count from the eye.
local far_and_below = {
  size = { 64, 64 }, light = vec4(-161626, -189646, -69973, 1),
  camera = { eye = vec3(-0.11, -0.82, -0.11), target = vec3(0, 1, 0), fovy = 60, near = 0.01, far = 60 },
  { mesh.box(1), "none", vec3(0.6531943748850364, 0.5613704404378034, 0.11676517756713434),
    vec3(-0.9282436377624006, -0.30051307347509093, 0.21921597027630035), 120.6, vec3(2.86, 1.08, 0.86) } }

test("the_exact_map_of_a_light_that_is_far_is_exact", function()
  found.at_its_size(far_and_below, function(world, light)
    local truth = given.draw("truth", world, light)
    local picture = given.draw("shadow_map_exact", world, light, { cells = 64, fit = "view", count = false })
    expect_equal(beyond(picture, truth), 0)
  end)
end)

row{ case = 31, title = "A light in a face", expected = "the picture of a light 2^-17 of the caster's size beside it",
     facts = { "a_light_in_a_face_draws_what_it_does_a_hair_beside_it" } }
row{ case = 32, title = "A side that rounding turns round", expected = "each pixel of it is counted, as a front or as a back",
     facts = { "a_side_that_rounding_turns_round_is_counted_where_no_face_is_culled" } }
row{ case = 33, title = "A near plane of a hundred-thousandth", expected = "wrong at most where surfaces are within 12 z²/(n 2^24) of each other",
     facts = { "a_near_plane_of_a_hundred_thousandth_errs_by_its_depth_s_steps_and_no_more" },
     without = "right here: it moves no depth, and cuts off no foot; moving them is what keeps lit faces from their own volumes" }
row{ case = 34, title = "A light within its caster's bounds", expected = "all around is dark; one map tells no depths there, since its near plane is at 1e-5 of the far",
     facts = { "one_map_of_a_light_within_its_caster_tells_no_depths_and_volumes_do" } }
row{ case = 35, title = "A light in a sheet a ten-thousandth wide", expected = "edge on, it throws no shadow",
     facts = { "a_light_in_a_narrow_sheet_throws_no_shadow_of_it" },
     without = "right too: the sheet is not lit, and throws nothing" }
row{ case = 36, title = "A caster thinner than a texel", expected = "a shadow of its own width; a map's is a texel wide, or none",
     facts = { "a_caster_thinner_than_a_texel_throws_a_texel_s_shadow_here_and_there" } }
row{ case = 37, title = "A shadow narrower than a rasterizer tells", expected = "at most single pixels of it: corners are moved by 1/256 of a pixel",
     facts = { "a_shadow_narrower_than_a_hundredth_of_a_pixel_comes_and_goes_by_single_pixels" },
     without = "right too: no sample of it is more than a pixel" }
row{ case = 38, title = "A light sixty thousand units away", expected = "the shadow of a direction",
     facts = { "a_light_sixty_thousand_units_away_leaves_volumes_as_they_are_and_moments_rough" } }
row{ case = 39, title = "A surface that the light grazes", expected = "lit and dark are the same: Lambert's cosine is 0",
     facts = { "a_surface_that_the_light_grazes_looks_the_same_lit_and_dark" },
     without = "right too: nobody sees which of the two it drew" }
row{ case = 40, title = "Counting from both ends of the ray, near plane at a hundred-thousandth", expected = "z-fail and z-pass draw the same",
     facts = { "z_fail_and_z_pass_draw_the_same_where_depth_tells_hardly_anything" },
     without = "right too: it moves no depths, so that caps and casters stay together" }
row{ case = 41, title = "A light eight hundred thousand units away, in a world of a million units", expected = "the shadow of a direction, by maps too",
     facts = { "a_light_far_from_a_large_world_lights_it_by_maps_too", "the_exact_map_of_a_light_that_is_far_is_exact" },
     without = "right too: it takes no fragment's climb off, and so squares nothing" }
