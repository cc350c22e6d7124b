-- What the search for departures found of maps whose numbers are far larger than what they tell apart.
local found = require "found"
local given = require "given"

local beyond = given.beyond

-- ---- 45: a light a million units away, and a grid of triangles

local exact = { cells = 256, fit = "view", count = false }

-- An edge and the light are a plane. Of two corners seen from so far away the product is lost to rounding.
local beside_an_edge = {
  size = { 64, 64 }, light = vec4(-1273039, 1641434, 1060184, 1),
  camera = { eye = vec3(-2, 0, -4), target = vec3(0, 1, 0), fovy = 60, near = 0.01, far = 60 },
  { mesh.sphere(0.5, 12, 7), "none", vec3(0.631012272179512, 0, -0.4134620459821765), vec3(0, 1, 0), 0, vec3(1, 1, 1) } }

-- A float names another cell of the grid, which lists another triangle, or none.
local in_another_cell = {
  size = { 64, 64 }, light = vec4(457179.13, 323644.77, 240652.12, 1),
  camera = { eye = vec3(-0.808322042078816, -1.3958403716847956, 4.3776511077338665), target = vec3(-1, 1, 0),
             fovy = 36.222358350190284, near = 0.01, far = 60 },
  { mesh.torus(0.5, 0.2, 12, 6), "none", vec3(0, 1, 1), vec3(0, 1, 0), 0, vec3(1.13, 0.25, 0.88) },
  { mesh.sphere(0.5, 12, 7), "none", vec3(0.71, 1.37, -1.22), vec3(0, 1, 1), 0,
    vec3(0.0036369349631626066, 0.99655127773968, 0.4622350496651863) },
  { mesh.box(1), "none", vec3(0.7650983738586525, 0.30278186337815927, 0.5157063043526264), vec3(0, 0, -1), 0,
    vec3(0.059826657342126985, 0.04172011481239187, 0.39219013542189607) } }

test("the_exact_map_of_a_light_a_million_units_away_is_exact", function()
  for name, world in pairs{ beside_an_edge = beside_an_edge, in_another_cell = in_another_cell } do
    found.at_its_size(world, function(objects, light)
      local truth = given.draw("truth", objects, light)
      local picture = given.draw("shadow_map_exact", objects, light, exact)
      expect_equal(beyond(picture, truth), 0, name)
      ours("no wrong pixel", picture)
    end)
  end
end)

-- ---- 44: a light near a surface, and the eye far from it

-- .4 m before the light a cube's depths tell 4e-8 m; floats that begin at an eye 100 m away tell places by 1e-5 m.
local function near_light(away, angle)
  local middle = vec3(0, 0.35, 0.4)
  return {
    size = { 64, 64 }, light = vec4(0, 0.75, 0.75, 1),
    camera = { eye = middle + vec3(0.6 * math.cos(angle), 0.8, 0.6 * math.sin(angle)) * away, target = middle,
               fovy = 2 * math.deg(math.atan(0.3 / away)), near = away / 20, far = 2 * away },
    { mesh.plane(1, 1), "none", middle, vec3(0, 1, 0), 0, vec3(1.5, 1, 1.5) } }
end

test("a_cube_of_maps_leaves_lit_what_is_near_its_light_and_far_from_the_eye", function()
  local cube = { size = 512, filter = "NEAREST", keep = true, cull = true }
  for _, away in ipairs{ 1, 5, 20, 100, 1000 } do
    for k = 0, 3 do
      found.at_its_size(near_light(away, 0.3 + k), function(world, light)
        local truth = given.draw("truth", world, light)
        local picture = given.draw("shadow_map_cube", world, light, cube)
        expect_equal(beyond(picture, truth), 0, away .. " m away, " .. k)
        if away == 100 and k == 0 then
          ours("all of the sheet is lit", picture)
          local load = shader.load
          shader.load = function(name) return load(name == "shadow_map_cube" and "cube_as_listed" or name) end
          local listed = given.draw("shadow_map_cube", world, light, { size = 512, filter = "LINEAR" })
          shader.load = load
          local wrong = beyond(listed, truth)
          expect(wrong > 1000, wrong)
          naive("compared as floats have it: " .. wrong .. " pixels are in shadow", listed)
        end
      end)
    end
  end
end)

-- Stated, not mended: one map's depths are compared as the eye's floats have them.
test("one_map_of_a_light_near_a_surface_holds_for_an_eye_a_thousand_times_as_far_away_and_not_for_any", function()
  local ways = { shadow_map_fbo = { size = 512, bias = "offset" }, shadow_map_copy = { size = 512, bias = "recommended" },
                 shadow_map_sampler = { size = 512, bias = "offset", compare = "LEQUAL" } }
  for recipe, params in pairs(ways) do
    -- To which side rounding goes is the direction's matter.
    for away, holds in pairs{ [100] = true, [400] = true, [10000] = false } do
      local wrong = 0
      for k = 0, 3 do
        found.at_its_size(near_light(away, 0.3 + k), function(world, light)
          wrong = wrong + beyond(given.draw(recipe, world, light, params), given.draw("truth", world, light))
        end)
      end
      if holds then expect_equal(wrong, 0, recipe .. ", " .. away .. " m away") else expect(wrong > 1000, recipe) end
    end
  end
end)

row{ case = 44, title = "A light near a surface that the eye is far from", expected = "what faces the light is lit",
     facts = { "a_cube_of_maps_leaves_lit_what_is_near_its_light_and_far_from_the_eye",
               "one_map_of_a_light_near_a_surface_holds_for_an_eye_a_thousand_times_as_far_away_and_not_for_any" } }
row{ case = 45, title = "A light a million units away, and a grid of triangles", expected = "the truth, beside its edges",
     facts = { "the_exact_map_of_a_light_a_million_units_away_is_exact" },
     without = "no listing keeps triangles: a map of depths is off by its texels" }
