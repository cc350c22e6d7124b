-- Averages of hard shadows against rays to the same points.
local size = 96

-- The visibility of a light as rays see it, toward the given points alone.
local function traced(name, options)
  return frame(size, size, function()
    local world = scene.load(name)
    local light = { center = world.lights[1].xyz, radius = 0.3 }
    gl.BindTexture(gl.TEXTURE_2D, shadow.truth(world, world.camera, light, options))
    mesh.quad():draw(shader.compile{
      vertex = [[#version 330 core
        layout(location = 0) in vec3 position;
        void main() { gl_Position = vec4(position, 1.0); }]],
      fragment = [[#version 330 core
        uniform sampler2D visibility;
        out vec4 fragment;
        void main() { fragment = vec4(vec3(texelFetch(visibility, ivec2(gl_FragCoord.xy), 0).r), 1.0); }]],
    })
  end)
end

local function accumulated(name, set)
  set.radius, set.storage = set.radius or 0.3, set.storage or "float32"
  return render("soft_accumulated", { scene = name, size = { size, size }, set = set, visibility = true })
end

-- The background is no surface: it is lit for the truth, and the recipe's clear colour in its picture.
local function rmse(picture, truth)
  local sum, count = 0, 0
  for y = 0, size - 1 do
    for x = 0, size - 1 do
      if picture:depth(x, y) < 1 then
        count = count + 1
        sum = sum + ((picture:color(x, y)) - (truth:color(x, y))) ^ 2
      end
    end
  end
  expect(count > 500)
  return math.sqrt(sum / count) / 255
end

-- A rasteriser may differ from rays at a hard shadow's edge, by one of the N points: the edge's pixels,
-- less than a tenth of all, are then off by 1/N, which is an RMSE of 0.3/N at most.
test("volumes_give_what_rays_to_the_same_points_give", function()
  for _, name in ipairs{ "tetra", "table", "stairs" } do
    for _, pattern in ipairs{ "random", "jitter", "grid", "hammersley", "r2", "sobol", "owen" } do
      local picture = accumulated(name, { samples = 4, pattern = pattern, seed = 3 })
      local off = rmse(picture, traced(name, { samples = 4, pattern = pattern, seed = 3 }))
      expect(off < 0.3 / 4, name .. ", " .. pattern .. ": " .. off)
    end
  end
end)

test("the_error_falls_faster_than_that_of_random_points", function()
  for _, technique in ipairs{ "volumes", "maps" } do
    local truth = traced("tetra", { samples = 1024, seed = 9 })
    local few = rmse(accumulated("tetra", { technique = technique, samples = 4 }), truth)
    local many = rmse(accumulated("tetra", { technique = technique, samples = 64 }), truth)
    -- Sixteen times the points are a quarter of random's error.
    expect(many < few / 4, technique .. ": " .. few .. " with 4 points, " .. many .. " with 64")
  end
end)

-- The penumbra's width says how many points: what they leave is held to the error asked for, over all of
-- the picture. An estimate, which knows nothing of penumbrae over each other, nor of a caster's shadow on
-- itself: a quarter more is allowed.
test("as_many_points_are_taken_as_the_error_asked_for_needs", function()
  for _, name in ipairs{ "table", "tetra" } do
    local truth, taken = traced(name, { samples = 4096, seed = 9 }), {}
    for _, asked in ipairs{ 0.02, 0.005 } do
      local picture = accumulated(name, { error = asked })
      local surfaces = 0
      for y = 0, size - 1 do
        for x = 0, size - 1 do surfaces = surfaces + (picture:depth(x, y) < 1 and 1 or 0) end
      end
      local off = rmse(picture, truth) * math.sqrt(surfaces) / size
      taken[#taken + 1] = #picture.passes
      expect(off <= 1.25 * asked, name .. ": " .. off .. " where " .. asked .. " was asked for, of " .. #picture.passes .. " passes")
    end
    expect(taken[2] > taken[1])
  end
end)

test("volumes_and_maps_agree_but_for_the_map_s_texels", function()
  local set = { samples = 16, technique = "volumes" }
  local volumes = accumulated("table", set)
  set.technique, set.size = "maps", 2048
  expect(volumes:difference(accumulated("table", set)).rmse < 0.02)
end)

-- In 8 bits a 128th of white is less than a step of 1/127, and dropped 128 times.
test("the_storage_is_the_recipe_s_choice", function()
  local white = accumulated("tetra", { samples = 128, radius = 0, storage = "float32" })
  local black = accumulated("tetra", { samples = 128, radius = 0, storage = "snorm8" })
  local lit = 0
  for y = 0, size - 1 do
    for x = 0, size - 1 do
      lit = lit + ((white:color(x, y)) == 255 and 1 or 0)
      expect_equal((black:color(x, y)), 0)
    end
  end
  expect(lit > 1000)
end)
