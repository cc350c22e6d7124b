-- Scenes that a test makes of its own objects, drawn by recipes and held against the exact truth. The
-- test's folder has scenes/given.lua, which returns the one in hand.
local given = { size = 96 }

-- A world's picture by a recipe of scripts/; `light` is a vec4, `params` what else the recipe takes.
function given.draw(recipe, world, light, params)
  given.world = world
  local listing = require(recipe)
  return frame(given.size, given.size, function(r)
    r.scene = scene.load "given"
    r.params = { light = light, darkness = 0.25, radius = 0, samples = 1 }
    for name, value in pairs(params or {}) do r.params[name] = value end
    listing.setup(r)
    listing.draw(r)
  end)
end

local function differ(a, b, x, y, u, v)
  local p, q = vec4(a:color(x, y)), vec4(b:color(u, v))
  local off = (p - q):abs()
  return math.max(off.x, off.y, off.z)
end

-- Whether the truth changes around a pixel: by more than shading does from one to the next.
local function at_edge(truth, x, y)
  for v = math.max(y - 1, 0), math.min(y + 1, given.size - 1) do
    for u = math.max(x - 1, 0), math.min(x + 1, given.size - 1) do
      if differ(truth, truth, x, y, u, v) > 8 then return true end
    end
  end
  return false
end

-- How many pixels differ by more than rounding; how many of those are beside no edge of the truth; and
-- how many of the others there may be: GL rounds vertices to 1/256 of a pixel, and the recipes move
-- depths by as much of their slope, so that of the pixels along an edge one in some hundreds falls to the
-- other side: at most one in 50, or in `one_in` where a pixel has several edges.
function given.wrong(picture, truth, one_in)
  local wrong, beyond, edges = 0, 0, 0
  for y = 0, given.size - 1 do
    for x = 0, given.size - 1 do
      local is_edge = at_edge(truth, x, y)
      if is_edge then edges = edges + 1 end
      if differ(picture, truth, x, y, x, y) > 3 then
        wrong = wrong + 1
        if not is_edge then beyond = beyond + 1 end
      end
    end
  end
  return wrong, beyond, 2 + edges // (one_in or 50)
end

-- Of those that differ the ones beside no edge of the truth.
function given.beyond(picture, truth)
  local _, beyond = given.wrong(picture, truth)
  return beyond
end

function given.expect_same(picture, truth, words, one_in)
  local wrong, beyond, allowed = given.wrong(picture, truth, one_in)
  expect(beyond == 0, words .. ": " .. beyond .. " pixels are wrong beyond an edge")
  expect(wrong <= allowed, words .. ": " .. wrong .. " pixels are wrong at edges, where " .. allowed .. " may be")
end

-- The recipes that hold everywhere, against the truth.
function given.expect_truth(world, light, words, one_in)
  local truth = given.draw("truth", world, light)
  for _, recipe in ipairs{ "volumes_zfail", "volumes_auto" } do
    given.expect_same(given.draw(recipe, world, light), truth,
                      (words or "") .. " " .. recipe .. ", light " .. tostring(light), one_in)
  end
  return truth
end

-- How many pixels of a picture differ from those of another.
function given.differing(picture, other) return picture:difference(other, 3).differing end

function given.floor(width)
  return { name = "floor", role = "receiver", mesh = mesh.plane(width or 12, width or 12),
           color = vec3(0.8, 0.7, 0.6) }
end

function given.caster(name, shape, model)
  return { name = name, role = "caster", mesh = shape, model = model, color = vec3(0.4, 0.6, 0.9) }
end

-- From above and in front.
given.camera = { eye = vec3(0.7, 4.4, 6.2), target = vec3(0, 0.5, 0), fovy = 45, near = 0.5, far = 60 }

function given.world_of(objects, camera)
  return { title = "given", camera = camera or given.camera, objects = objects }
end

-- Meshes as one, without what they share.
function given.joined(meshes)
  local positions, indices = {}, {}
  for _, one in ipairs(meshes) do
    local first = #positions
    for i = 0, one.vertices - 1 do positions[first + i + 1] = one:position(i) end
    for i = 0, one.triangles - 1 do
      for _, corner in ipairs{ one:triangle(i) } do indices[#indices + 1] = first + corner end
    end
  end
  return mesh.new{ positions = positions, indices = indices }
end

return given
