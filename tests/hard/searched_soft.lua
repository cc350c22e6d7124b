-- What the search for departures found of shadows that are flattened onto their receiver, soft ones among them.
local found = require "found"
local given = require "given"
local beyond = given.beyond

-- How many pixels show more of the floor than a shadow leaves: a quarter of its red, .8.
local function lit(picture)
  local count = 0
  for y = 0, given.size - 1 do
    for x = 0, given.size - 1 do
      if (picture:color(x, y)) > 0.25 * 0.8 * 255 + 0.5 then count = count + 1 end
    end
  end
  return count
end

-- The picture that draw gives where GL clips at the near and the far plane, as it does unless told.
local function clipped(draw)
  local enable = gl.Enable
  gl.Enable = function(what) if what ~= gl.DEPTH_CLAMP then enable(what) end end
  local picture = draw()
  gl.Enable = enable
  return picture
end

-- ---- 42: a caster at the light

-- The light is inside of a box, 4 mm before one of its faces: 1/1300 of the way to the floor that is seen.
local at_the_light = {
  size = { 64, 64 }, light = vec4(0.424447, 1.23828, -0.496288, 1),
  camera = { eye = vec3(-2, 3, -5), target = vec3(-2, 0, -5.2), fovy = 26, near = 0.01, far = 60 },
  { mesh.box(1), "none", vec3(0, 1.5, 0), vec3(0, 1, 0), 0, vec3(1, 1, 1) } }

test("a_caster_at_the_light_is_in_the_texture_of_the_receiver_s_shadow", function()
  found.at_its_size(at_the_light, function(world, light)
    local texture = { shape = "sphere", pattern = "hammersley", seed = 1, size = 512 }
    local picture = given.draw("soft_parallelogram", world, light, texture)
    expect_equal(lit(picture), 0)
    ours("the box hides the light from all of the floor", picture)
    -- What a near plane leaves: the matrix has its at 1/1024 of the way, and GL cuts off what is before it.
    local cut = clipped(function() return given.draw("soft_parallelogram", world, light, texture) end)
    local missing = lit(cut)
    expect(missing > 100, missing)
    naive("with a near plane at 1/1024 of the way " .. missing .. " pixels are lit", cut)
  end)
end)

-- ---- 43: flattened under a near plane of a hundred-thousandth

-- The light is inside of a box, and 1.6 cm over the floor that the box stands in.
local flattened = {
  size = { 64, 64 }, light = vec4(0, 0.0156, -1, 1),
  camera = { eye = vec3(0, 2, 5), target = vec3(-4, 0, -3.2), fovy = 4, near = 2.03e-05, far = 60 },
  { mesh.box(1), "none", vec3(0, 0, -1), vec3(0, 1, 0), 0, vec3(1, 1, 1) } }

-- Of the room's shadows those of the light's centre alone.
local one_point = { soft = true, jitters = 1, shape = "sphere", pattern = "hammersley", seed = 1, storage = "float32",
                    walls = true, clip = true, tessellation = 16, turn = 0, error = 0 }

test("a_flattened_shadow_is_whole_under_a_near_plane_of_a_hundred_thousandth", function()
  found.at_its_size(flattened, function(world, center)
    -- Which of these a float takes for beyond the far plane is its rounding's choice.
    local most, cut = 0, nil
    for k = 0, 7 do
      local angle = 0.2 + k * math.pi / 4
      local light = center + vec4(math.cos(angle), 0, math.sin(angle), 0) / 4
      for _, recipe in ipairs{ "room", "room_fast" } do
        local picture = given.draw(recipe, world, light, one_point)
        expect_equal(lit(picture), 0, recipe .. ", light " .. k)
        if recipe == "room" and k == 0 then ours("all of the floor is dark", picture) end
      end
      local picture = clipped(function() return given.draw("room", world, light, one_point) end)
      if lit(picture) > most then most, cut = lit(picture), picture end
    end
    expect(most > 100, most)
    naive("clipped between the near plane and the far one: " .. most .. " pixels are lit", cut)
  end)
end)

-- ---- 46: a caster that the floor cuts, far from the world's origin

local sunk = {
  offset = vec3(-270171, 302560, 29777), size = { 64, 64 }, light = vec4(1, 0.0156, -2.9, 1),
  camera = { eye = vec3(1, 4, -4), target = vec3(0, 0, 0), fovy = 21.769239732107476, near = 0.01, far = 60 },
  { mesh.torus(0.5, 0.2, 12, 6), "none", vec3(1, 0, 0), vec3(0, 1, 0), 0, vec3(1, 1, 1) } }

test("a_caster_that_the_floor_cuts_throws_its_shadow_far_from_the_origin_too", function()
  found.at_its_size(sunk, function(world, from)
    for k = 0, 7 do
      local light = from + vec4(0, 0.03 * k, 0, 0)
      local every = given.draw("room", world, light, one_point)
      local outlined = given.draw("room_fast", world, light, one_point)
      expect_equal(beyond(outlined, every), 0, "a light " .. 0.0156 + 0.03 * k .. " over the floor")
      if k == 0 then ours("by outlines what every triangle flattened gives", outlined) end
    end
  end)
end)

row{ case = 42, title = "A caster at the light, and a receiver's own shadow texture",
     expected = "what surrounds the light hides it from all of the floor",
     facts = { "a_caster_at_the_light_is_in_the_texture_of_the_receiver_s_shadow" } }
row{ case = 43, title = "A flattened shadow under a near plane of a hundred-thousandth", expected = "the whole shadow",
     facts = { "a_flattened_shadow_is_whole_under_a_near_plane_of_a_hundred_thousandth" } }
row{ case = 46, title = "A caster that the floor cuts, far from the world's origin", expected = "the shadow of what is above the floor",
     facts = { "a_caster_that_the_floor_cuts_throws_its_shadow_far_from_the_origin_too" },
     without = "right too: it flattens every triangle, and so fills nothing" }
