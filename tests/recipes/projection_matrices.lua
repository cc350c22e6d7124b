-- The matrices against the slides' and against lines met with planes; the picture against where the
-- vertices' images are.
local analytic = require "analytic"

-- M on paper, up to the factor that shadow.planar chooses: (P·L) I - L Pᵀ.
local function by_definition(plane, light)
  local product = plane:dot(light)
  local columns = {}
  for j = 1, 4 do
    local unit = vec4(j == 1 and 1 or 0, j == 2 and 1 or 0, j == 3 and 1 or 0, j == 4 and 1 or 0)
    columns[j] = unit * product - light * plane[j]
  end
  return mat4(columns[1], columns[2], columns[3], columns[4])
end

-- Whether a = k b for one k > 0.
local function expect_same_projection(a, b, words)
  local k
  for i = 1, 4 do
    for j = 1, 4 do k = k or (b[i][j] ~= 0 and a[i][j] / b[i][j] or nil) end
  end
  expect(k > 0, words)
  for i = 1, 4 do
    expect_near(a[i], b[i] * k, 1e-15, "one rounding of numbers of size 1 to 8")
  end
end

-- Planes, and lights on their positive side: small whole numbers, so that products are exact.
local planes = { vec4(0, 1, 0, 2), vec4(1, 2, -2, 6), vec4(-3, 1, 1, 4) }

test("from_the_origin_the_matrix_is_the_slide_s", function()
  for _, p in ipairs(planes) do
    local slide = mat4.rows(p.w, 0, 0, 0,  0, p.w, 0, 0,  0, 0, p.w, 0,  -p.x, -p.y, -p.z, 0)
    expect_same_projection(shadow.planar_from_origin(p), slide, tostring(p))
  end
end)

test("from_a_point_the_matrix_is_the_definition_s", function()
  for _, p in ipairs(planes) do
    local point = vec3(1, 5, 2)
    expect_same_projection(shadow.planar_from_point(p, point), by_definition(p, vec4(point, 1)),
                           tostring(p))
  end
end)

test("along_a_direction_the_sense_of_it_does_not_matter", function()
  for _, p in ipairs(planes) do
    local d = vec3(1, 5, 2)
    expect_same_projection(shadow.planar_along(p, d), by_definition(p, vec4(d, 0)), tostring(p))
    expect_equal(shadow.planar_along(p, d), shadow.planar_along(p, -d))
  end
end)

test("z_0_is_the_plane_and_the_light_0_0_1_0", function()
  expect_equal(shadow.planar(vec4(0, 0, 1, 0), vec4(0, 0, 1, 0)),
               mat4.rows(1, 0, 0, 0,  0, 1, 0, 0,  0, 0, 0, 0,  0, 0, 0, 1))
end)

local forms = {
  ["light"]     = { plane = vec4(0, 1, 0, 1.5), light = vec4(1.25, 1.5625, 0.625, 1) },
  ["origin"]    = { plane = vec4(0, 1, 0, 1.5), light = vec4(0, 0, 0, 1) },
  ["point"]     = { plane = vec4(0, 1, 0, 1.5), light = vec4(1, 1.25, 0.5, 1) },
  ["direction"] = { plane = vec4(0, 1, 0, 1.5), light = vec4(1, 1.25, 0.5, 0) },
  ["z = 0"]     = { plane = vec4(0, 0, 1, 0),   light = vec4(0, 0, 1, 0) },
}

-- What may be in front of an image is nearer; five of eight at least are seen.
test("each_vertex_s_image_is_where_its_line_from_the_light_meets_the_plane", function()
  local size = 512
  local world = scene.load "cube"
  local viewer = analytic.viewer(world.camera, size, size)
  local marker = analytic.levels(vec3(0.76, 0.10, 0.36))
  local cube = world:object "cube"
  for name, form in pairs(forms) do
    local picture = render("projection_matrices", { size = { size, size }, set = { form = name } })
    local seen = 0
    for corner = 0, 7 do
      local v = cube.model:transform_point(vec3(corner & 1, corner >> 1 & 1, corner >> 2 & 1) * 0.5
                                           - 0.25)
      local at, depth = analytic.window(viewer, analytic.cast(form.plane, form.light, v))
      local x, y = math.floor(at.x), math.floor(at.y)
      if analytic.rgb(picture, x, y) == marker then
        seen = seen + 1
      else
        expect(picture:depth(x, y) < depth, name .. ", vertex " .. corner)
      end
    end
    expect(seen >= 5, name .. ": only " .. seen .. " images are seen")
  end
end)

test("the_flattened_cube_covers_the_hull_of_the_vertices_images", function()
  local size = 256
  local world = scene.load "cube"
  local viewer = analytic.viewer(world.camera, size, size)
  local cube = world:object "cube"
  local dark = analytic.levels(vec3(0.32, 0.32, 0.36))
  for name, form in pairs(forms) do
    local picture = render("projection_matrices", { size = { size, size }, set = { form = name } })
    local images = {}
    for i, v in ipairs(analytic.vertices(cube)) do
      images[i] = analytic.cast(form.plane, form.light, v)
    end
    local hull = analytic.window_hull(viewer, images)
    local before, after = picture:pass(1), picture:pass(2)
    local inside = 0
    for y = 0, size - 1 do
      for x = 0, size - 1 do
        local side = analytic.side(hull, x, y)
        local is_dark = analytic.rgb(after, x, y) == dark
        if side == "in" then
          inside = inside + 1
          -- Unless an axis is in front: these are nearer by 0.002 and more of window depth.
          local _, depth = analytic.window(viewer, analytic.on_plane(viewer, form.plane, x, y))
          expect(is_dark or before:depth(x, y) < depth - 1e-3, name .. ", " .. x .. ", " .. y)
        elseif side == "out" then
          expect(not is_dark, name .. ": dark at " .. x .. ", " .. y)
        end
      end
    end
    expect(inside > 200, name)
  end
end)
