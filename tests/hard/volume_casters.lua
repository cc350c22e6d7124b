-- Casters that no silhouette algorithm was drawn for: open, with no orientation, without area, in the
-- light's plane; and volumes that end nowhere.
local given = require "given"
local listing = require "listing"

local light = vec4(1.6, 4.5, 1.2, 1)
local lights = { light, vec4(-2.5, 1.8, -0.7, 1), vec4(0.4, 1, 0.3, 0) }

-- Stencils of z-fail, pixel by pixel the same.
local function expect_same_counts(a, b, from, words)
  local first, second = given.draw("volumes_zfail", a, from), given.draw("volumes_zfail", b, from)
  expect_equal(first:difference(second).stencil, 0, words)
end

local function alone(shape, model)
  return given.world_of{ given.floor(), given.caster("caster", shape, model) }
end

-- ---- 14: triangles without area

test("triangles_without_area_change_nothing_in_the_stencil", function()
  local ball = given.joined{ mesh.sphere(0.8, 16, 9):transformed(mat4.translate(0, 1.2, 0)) }
  local positions, indices = {}, {}
  for i = 0, ball.vertices - 1 do positions[i + 1] = ball:position(i) end
  for i = 0, ball.triangles - 1 do
    local a, b, c = ball:triangle(i)
    -- An edge there and back, a point, and one whose corners are in one line, halves being exact.
    positions[#positions + 1] = (ball:position(a) + ball:position(b)) / 2
    for _, corner in ipairs{ a, b, c,  a, b, a,  b, b, b } do indices[#indices + 1] = corner end
  end
  local spoilt = mesh.new{ positions = positions, indices = indices }
  expect_equal(spoilt.triangles, 3 * ball.triangles)
  for _, from in ipairs(lights) do expect_same_counts(alone(ball), alone(spoilt), from) end
  ours(spoilt.triangles - ball.triangles .. " triangles without area change no stencil", given.draw("volumes_zfail", alone(spoilt), light))
end)

test("a_needle_between_two_faces_leaves_no_streak", function()
  -- A quad in two halves, and along their common edge a triangle whose third corner is on that edge.
  local function halves(with)
    local positions = { vec3(-1, 1, -1), vec3(1, 1, -1), vec3(1, 1, 1), vec3(-1, 1, 1), vec3(0, 1, 0) }
    local indices = { 0, 2, 1,  0, 3, 2 }
    if with then for _, corner in ipairs{ 0, 4, 2,  2, 4, 0 } do indices[#indices + 1] = corner end end
    return mesh.new{ positions = positions, indices = indices }
  end
  for _, from in ipairs(lights) do expect_same_counts(alone(halves(false)), alone(halves(true)), from) end
end)

-- ---- 15: open meshes and such as have no orientation

local function turned_back(one, every)
  local positions, indices = {}, {}
  for i = 0, one.vertices - 1 do positions[i + 1] = one:position(i) end
  for i = 0, one.triangles - 1 do
    local a, b, c = one:triangle(i)
    if i % every == 0 then a, b = b, a end
    for _, corner in ipairs{ a, b, c } do indices[#indices + 1] = corner end
  end
  return mesh.new{ positions = positions, indices = indices }
end

test("a_teapot_and_a_moebius_strip_are_the_truth", function()
  local teapot = mesh.teapot(1.3, 5):transformed(mat4.translate(0, 0.4, 0))
  local strip = require("scenes.mobius").objects[2]
  for _, from in ipairs(lights) do
    given.expect_truth(alone(teapot), from, "teapot")
    given.expect_truth(alone(strip.mesh, strip.model), from, "strip")
  end
  ours "a teapot, a Möbius strip, an open box: the truth"
end)

test("an_open_box_and_a_lid_with_the_opposite_winding_are_the_truth", function()
  local positions = { vec3(-0.8, 0.4, -0.8), vec3(0.8, 0.4, -0.8), vec3(0.8, 0.4, 0.8), vec3(-0.8, 0.4, 0.8),
                      vec3(-0.8, 1.6, -0.8), vec3(0.8, 1.6, -0.8), vec3(0.8, 1.6, 0.8), vec3(-0.8, 1.6, 0.8) }
  -- Outward, but for the last: a lid that leans on one edge of the others and runs along it as they do.
  local indices = { 0, 1, 2, 0, 2, 3,  0, 4, 5, 0, 5, 1,  1, 5, 6, 1, 6, 2,  2, 6, 7, 2, 7, 3,
                    3, 7, 4, 3, 4, 0 }
  for _, corner in ipairs{ 4, 8, 9, 4, 9, 5 } do indices[#indices + 1] = corner end
  positions[9], positions[10] = vec3(-0.8, 2.4, -0.2), vec3(0.8, 2.4, -0.2)
  local box = mesh.new{ positions = positions, indices = indices }
  for _, from in ipairs(lights) do given.expect_truth(alone(box), from, "open box") end
end)

test("which_way_the_triangles_of_an_open_mesh_run_changes_no_count", function()
  local sheet = mesh.grid(2, 2, 8, 8, function(x, z) return 1 + 0.3 * math.sin(x) * math.cos(z) end)
  for _, from in ipairs(lights) do
    for _, every in ipairs{ 1, 2, 3, 5 } do
      expect_same_counts(alone(sheet), alone(turned_back(sheet, every)), from, "every " .. every)
    end
    given.expect_truth(alone(turned_back(sheet, 3)), from, "sheet")
  end
end)

-- The lecture's loop counts lit faces alone: those that run the other way throw nothing.
test("the_lecture_s_loop_loses_the_triangles_that_run_the_other_way", function()
  local function counts(shape) return listing.volumes(alone(shape), light, "zpass", nil, "lit") end
  local sheet = mesh.plane(2, 2, 4, 4):transformed(mat4.translate(0, 1, 0))
  local right, lost = counts(sheet), 0
  local picture = counts(turned_back(sheet, 2))
  for y = 0, given.size - 1 do
    for x = 0, given.size - 1 do
      if right:stencil(x, y) == 1 and picture:stencil(x, y) == 0 then lost = lost + 1 end
    end
  end
  expect(lost > 100, "only " .. lost .. " pixels of shadow are lost")
  naive("the loop over lit faces loses " .. lost .. " pixels of shadow", picture)
  ours("whichever way triangles run: no pixel lost", given.draw("volumes_zfail", alone(turned_back(sheet, 2)), light))
end)

-- ---- 16: the light in the plane of a triangle

test("a_light_in_the_plane_of_faces_is_the_truth_and_near_it_the_same_picture", function()
  local box = mesh.box(1.2):transformed(mat4.translate(0, 1, 0))
  -- In the planes of its top, of its top and its front, and at infinity along both.
  for _, from in ipairs{ vec4(2.5, 1.6, 0.3, 1), vec4(2.5, 1.6, 0.6, 1), vec4(1, 0, 0, 0) } do
    local truth = given.expect_truth(alone(box), from, "in the plane")
    for _, off in ipairs{ -1e-6, 1e-6 } do
      local beside = from + vec4(0, off, 0, 0)
      local picture = given.draw("volumes_zfail", alone(box), beside)
      given.expect_same(picture, truth, "off by " .. off .. " from " .. tostring(from))
      if from.x == 1 and off > 0 then ours("in the plane, and 1e-6 off it to either side: the truth", picture) end
    end
  end
end)

test("a_light_in_the_plane_of_a_sheet_throws_no_shadow_of_it", function()
  local sheet = mesh.plane(1.5, 1.5, 3, 3):transformed(mat4.translate(0, 1, 0))
  for _, from in ipairs{ vec4(3, 1, 0.2, 1), vec4(0.3, 1, 0.1, 1), vec4(1, 0, 0.5, 0) } do
    local picture = given.draw("volumes_zfail", alone(sheet), from)
    for y = 0, given.size - 1 do
      for x = 0, given.size - 1 do expect_equal(picture:stencil(x, y), 0, x .. ", " .. y) end
    end
  end
end)

-- ---- 17: caps at infinity

-- A camera that looks at a box against the empty sky: what it sees beyond the box is at infinity, and is
-- in shadow where the direction is one in which the light sees the box.
local function sky(projection_of, from)
  local camera = { eye = vec3(0.4, 1.1, 3), target = vec3(-0.3, 1.2, 0), fovy = 75, near = 0.1, far = 50 }
  given.world = given.world_of({ given.caster("box", mesh.box(0.9), mat4.translate(0, 1.2, 0)) }, camera)
  local here = scene.load "given"
  local projection = projection_of(camera)
  local picture = frame(given.size, given.size, function()
    local seen = { view = here.camera:view(), projection = projection }
    gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT)
    gl.Enable(gl.DEPTH_TEST)
    gl.DepthMask(false)
    gl.ColorMask(false, false, false, false)
    gl.Enable(gl.STENCIL_TEST)
    gl.StencilOpSeparate(gl.BACK, gl.KEEP, gl.INCR_WRAP, gl.KEEP)
    gl.StencilOpSeparate(gl.FRONT, gl.KEEP, gl.DECR_WRAP, gl.KEEP)
    shadow.volume(here.casters[1], nil, from):draw(shader.load "volume", seen)
    listing.show_count()
  end)
  local analytic = require "analytic"
  local clip = projection * here.camera:view()
  local points = {}
  for i, p in ipairs(analytic.vertices(here.casters[1])) do
    local q = clip * vec4(p * from.w - from.xyz, 0)
    if q.w <= 0 then return nil end
    points[i] = vec2((q.x / q.w + 1) / 2 * given.size, (q.y / q.w + 1) / 2 * given.size)
  end
  return picture, analytic.hull(points), analytic
end

local function infinite(camera) return shadow.infinite_perspective(camera.fovy, 1, camera.near) end

test("a_cap_at_infinity_covers_what_is_in_shadow_there_and_no_pixel_is_lost", function()
  local compared, shown = 0, nil
  for _, from in ipairs{ vec4(0.5, 1.6, 2.5, 1), vec4(0.2, 0.9, 1.4, 1), vec4(-0.6, 1.9, 1.9, 1) } do
    local picture, hull, analytic = sky(infinite, from)
    shown = shown or picture
    for y = 0, given.size - 1 do
      for x = 0, given.size - 1 do
        local side = analytic.side(hull, x, y)
        if side then
          expect_equal(picture:stencil(x, y), side == "in" and 1 or 0, x .. ", " .. y)
          if side == "in" then compared = compared + 1 end
        end
      end
    end
  end
  expect(compared > 1000, "hardly a pixel is in shadow at infinity: " .. compared)
  ours(compared .. " pixels in shadow at infinity, none lost", shown)
end)

test("a_far_plane_cuts_caps_off_and_the_count_with_them", function()
  local function finite(camera) return mat4.perspective(camera.fovy, 1, camera.near, camera.far) end
  local picture, hull, analytic = sky(finite, vec4(0.5, 1.6, 2.5, 1))
  local lost = 0
  for y = 0, given.size - 1 do
    for x = 0, given.size - 1 do
      if analytic.side(hull, x, y) == "in" and picture:stencil(x, y) ~= 1 then lost = lost + 1 end
    end
  end
  expect(lost > 100, "only " .. lost .. " pixels are lost")
  naive("with a far plane " .. lost .. " pixels are lost", picture)
end)

test("a_shadow_a_hundred_thousand_units_away_is_where_it_should_be", function()
  local analytic = require "analytic"
  local size, far = given.size, 1e5
  local camera = { eye = vec3(0, 2, 0), target = vec3(0, 2, -1), fovy = 60, near = 0.1, far = 10 * far }
  local wall = { name = "wall", role = "receiver", mesh = mesh.plane(4 * far, 4 * far),
                 model = mat4.translate(0, 0, -far) * mat4.rotate(90, 1, 0, 0) }
  local card = given.caster("card", mesh.box(1.6, 1.2, 0.1), mat4.translate(0.3, 2.1, -3) * mat4.rotate(30, 0, 0, 1))
  local from = vec4(-1.3, 2.6, 1.5, 1)
  local world = given.world_of({ wall, card }, camera)
  local picture = given.draw("volumes_zfail", world, from)
  local viewer = analytic.viewer(scene.load("given").camera, size, size)
  local caster = scene.load("given").casters[1]
  local points = analytic.vertices(caster)
  local covered = analytic.window_hull(viewer, points)
  for i, p in ipairs(points) do points[i] = analytic.cast(vec4(0, 0, 1, far), from, p) end
  local hull, compared = analytic.window_hull(viewer, points), 0
  for y = 0, size - 1 do
    for x = 0, size - 1 do
      local side = analytic.side(hull, x, y)
      if side and analytic.side(covered, x, y) == "out" then
        expect_equal(picture:stencil(x, y), side == "in" and 1 or 0, x .. ", " .. y)
        if side == "in" then compared = compared + 1 end
      end
    end
  end
  expect(compared > 200, "hardly a pixel of the shadow is seen: " .. compared)
end)

row{ case = 14, title = "Triangles without area", expected = "no change in the stencil",
     facts = { "triangles_without_area_change_nothing_in_the_stencil", "a_needle_between_two_faces_leaves_no_streak" },
     without = "right too: a triangle without area faces no light, and what its edges throw cancels" }
row{ case = 15, title = "Open and non-manifold meshes", expected = "signed multiplicities of edges: the truth, no streaks",
     facts = { "a_teapot_and_a_moebius_strip_are_the_truth", "an_open_box_and_a_lid_with_the_opposite_winding_are_the_truth",
               "which_way_the_triangles_of_an_open_mesh_run_changes_no_count",
               "the_lecture_s_loop_loses_the_triangles_that_run_the_other_way" } }
row{ case = 16, title = "The light in the plane of a triangle", expected = "either facing gives the same image",
     facts = { "a_light_in_the_plane_of_faces_is_the_truth_and_near_it_the_same_picture",
               "a_light_in_the_plane_of_a_sheet_throws_no_shadow_of_it" },
     without = "right too: it takes one facing for both ends of an edge" }
row{ case = 17, title = "Caps at infinity", expected = "no pixel lost against the analytic coverage",
     facts = { "a_cap_at_infinity_covers_what_is_in_shadow_there_and_no_pixel_is_lost",
               "a_far_plane_cuts_caps_off_and_the_count_with_them", "a_shadow_a_hundred_thousand_units_away_is_where_it_should_be" } }
