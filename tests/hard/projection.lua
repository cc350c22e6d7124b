-- Planar shadows where numbers are hard: what is expected, and what the listing as it stands in a
-- lecture gives.
local analytic = require "analytic"

local size = 256
local ground = vec4(0, 1, 0, 0)

local camera = { eye = vec3(0, 5, 9) }
function camera:view() return mat4.look_at(self.eye, vec3(0, 0, -2), vec3(0, 1, 0)) end
function camera:projection(aspect) return mat4.perspective(50, aspect, 0.5, 1000) end
local viewer = analytic.viewer(camera, size, size)

-- Stencil 1 and white where something is drawn.
local function stencilled(draw)
  return frame(size, size, function()
    gl.Clear(gl.COLOR_BUFFER_BIT | gl.STENCIL_BUFFER_BIT)
    gl.Enable(gl.STENCIL_TEST)
    gl.StencilFunc(gl.ALWAYS, 1, 0xFF)
    gl.StencilOp(gl.KEEP, gl.KEEP, gl.REPLACE)
    draw()
  end)
end

-- That of the mesh, flattened by the matrix.
local function footprint(caster, matrix)
  return stencilled(function()
    caster:draw(shader.load "flat", { view = camera:view(), projection = camera:projection(1),
                                      model = matrix, color = vec3(1) })
  end)
end

local function count(picture)
  local covered = 0
  for y = 0, picture.height - 1 do
    for x = 0, picture.width - 1 do
      if picture:stencil(x, y) == 1 then covered = covered + 1 end
    end
  end
  return covered
end

-- (P·L) I - L Pᵀ as the slide has it, whatever the plane's sign.
local function slide(plane, light)
  local product = plane:dot(light)
  local columns = {}
  for j = 1, 4 do
    local unit = vec4(j == 1 and 1 or 0, j == 2 and 1 or 0, j == 3 and 1 or 0, j == 4 and 1 or 0)
    columns[j] = unit * product - light * plane[j]
  end
  return mat4(columns[1], columns[2], columns[3], columns[4])
end

-- An upright rectangle over the ground, |x| <= 1, from `low` to `high`.
local function wall(low, high)
  return mesh.new{ positions = { -1, low, 0,  1, low, 0,  1, high, 0,  -1, high, 0 },
                   indices = { 0, 1, 2,  0, 2, 3 } }
end

local function images(caster, plane, light)
  local points = {}
  for i = 0, caster.vertices - 1 do
    points[i + 1] = analytic.cast(plane, light, caster:position(i))
  end
  return points
end

-- ---- 1: a light at infinity

local oblique = vec4(0.2, 1, -0.1, 0.3)
local toward = vec3(1, 2, 0.5)
local block = mesh.box(1.6, 0.8, 1.2):transformed(mat4.translate(0.3, 1.5, -0.4))

test("a_light_at_infinity_is_the_directional_matrix", function()
  for _, plane in ipairs{ ground, oblique, vec4(3, -1, 2, 5) } do
    expect_equal(shadow.planar(plane, vec4(toward, 0)), shadow.planar_along(plane, toward))
  end
end)

test("at_a_distance_d_the_shadow_is_off_by_one_over_d", function()
  local far = shadow.planar_along(oblique, toward)
  local v = vec3(0.3, 1.5, -0.4)
  local product  -- D times the error, its limit
  for k = 2, 7 do
    local d = 10.0 ^ k
    local near = shadow.planar(oblique, vec4(toward * d, 1))
    local off = near:transform_point(v):distance(far:transform_point(v)) * d
    if product then
      expect_near(off / product, 1, 10 / (d / 10), "the next term is smaller by another 1/D, of lengths "
                                                   .. "of a few units")
    end
    product = off
  end
end)

test("a_light_far_enough_draws_the_directional_shadow", function()
  local directional = footprint(block, shadow.planar_along(oblique, toward))
  local hull = analytic.window_hull(viewer, images(block, oblique, vec4(toward, 0)))
  for _, d in ipairs{ 1e5, 1e7, 1e12 } do
    local point = footprint(block, shadow.planar(oblique, vec4(toward * d, 1)))
    local differing = 0
    for y = 0, size - 1 do
      for x = 0, size - 1 do
        local s = point:stencil(x, y)
        local side = analytic.side(hull, x, y)
        if side then expect_equal(s, side == "in" and 1 or 0, d .. ": " .. x .. ", " .. y) end
        if s ~= directional:stencil(x, y) then differing = differing + 1 end
      end
    end
    -- A shift of under 1e-3 pixels, and vertices that are rounded to 1/256 of one: of an outline of
    -- under 300 pixels that moves by 1/256, one or two change.
    expect(differing <= 3, d .. ": " .. differing .. " pixels differ")
    if d == 1e12 then ours(differing .. " pixels differ at D = 1e12; D times the error tends to a constant", point) end
  end
end)

-- ---- 2: the light in the plane

test("a_light_in_the_plane_is_refused_in_one_sentence", function()
  for _, light in ipairs{ vec4(2, 0, 1, 1), vec4(1, 0, 0, 0), vec4(-3, 0, 7, 2) } do
    expect_error(function() shadow.planar(ground, light) end, "throws no shadow on it")
    expect_error(function() shadow.plane_toward(ground, light) end, "throws no shadow on it")
  end
  -- In it up to rounding: 0.1 + 0.2 is not 0.3.
  local plane = vec4(0, 1, 0, -0.3)
  expect_error(function() shadow.planar(plane, vec4(0, 0.1 + 0.2, 0, 1)) end, "throws no shadow")
  expect_error(function() render("projected_stencil", { set = { light = "2,0,1" } }) end,
               "The light is in the shadow plane")
  ours "refused: \"The light is in the shadow plane\""
end)

test("the_slide_s_matrix_throws_everything_into_the_light_there", function()
  local picture = footprint(block, slide(ground, vec4(2, 0, 1, 1)))
  expect_equal(count(picture), 0)
  naive("no shadow and no word: every point is mapped to the light", picture)
end)

test("a_light_next_to_the_plane_draws_nothing_that_is_not_a_number", function()
  for _, height in ipairs{ 1e-3, 1e-6, 1e-9, 1e-12 } do
    for _, sign in ipairs{ 1, -1 } do
      local picture = render("projected_stencil",
                             { size = { 128, 128 }, set = { light = vec3(2, sign * height, 1) } })
      local plain = picture:pass(1)
      for y = 0, 127 do
        for x = 0, 127 do
          -- All of the teapot is above such a light, or on the other side of the table.
          expect_equal(picture:pass(2):stencil(x, y), plain:stencil(x, y))
          local z = picture:depth(x, y)
          expect(z >= 0 and z <= 1, "depth " .. z)
        end
      end
      if height == 1e-12 and sign == 1 then ours("1e-12 above the plane no shadow is seen, and all depths are numbers", picture) end
    end
  end
end)

-- ---- 3: a vertex as high as the light

-- The light at (0, 4, 2) sees the wall |x| <= 1 in z = 0 up to its own height: the shadow is the wedge
-- behind it, without an end.
local lamp = vec4(0, 4, 2, 1)
local function in_wedge(p) return p and p.z < 0 and math.abs(p.x) < (2 - p.z) / 2 end

-- Whether the ground seen in pixel (x, y) is in the region: nil where that changes within a pixel, or
-- near the far plane or the horizon.
local function inside(region, x, y)
  local first
  for dy = -1, 1 do
    for dx = -1, 1 do
      local p = analytic.on_plane(viewer, ground, x + dx, y + dy)
      if p and p:distance(viewer.eye) > 500 then return nil end
      local is_in = region(p) and true or false
      if first == nil then first = is_in end
      if first ~= is_in then return nil end
    end
  end
  return first
end

local function expect_region(picture, region, words)
  local compared = 0
  for y = 0, size - 1 do
    for x = 0, size - 1 do
      local expected = inside(region, x, y)
      if expected ~= nil then
        if expected then compared = compared + 1 end
        expect_equal(picture:stencil(x, y), expected and 1 or 0, words .. ": " .. x .. ", " .. y)
      end
    end
  end
  expect(compared > 1000, words .. ": hardly a pixel of the region is seen")
end

test("a_vertex_at_the_light_s_height_throws_a_shadow_without_an_end", function()
  local m = shadow.planar(ground, lamp)
  expect_equal((m * vec4(1, 4, 0, 1)).w, 0)
  expect_region(footprint(wall(0, 4), m), in_wedge, "as high as the light")
end)

test("what_is_above_the_light_adds_nothing_and_does_not_wrap_around", function()
  local m = shadow.planar(ground, lamp)
  local high = footprint(wall(0, 8), m)
  expect_region(high, in_wedge, "twice as high")
  ours("the wedge without an end, no pixel beside its edge is wrong", high)
  expect_region(footprint(wall(0, 4.0001), m), in_wedge, "a little higher")
  expect_equal(count(footprint(wall(4.5, 8), m)), 0)
end)

-- Dividing by w before GL clips: the upper vertices come down on the other side of the light.
test("dividing_by_w_first_wraps_around", function()
  local points = images(wall(0, 8), ground, lamp)
  local divided = mesh.new{ positions = points, indices = { 0, 1, 2, 0, 2, 3 } }
  local picture = footprint(divided, mat4.identity())
  local wrong = 0
  for y = 0, size - 1 do
    for x = 0, size - 1 do
      local expected = inside(in_wedge, x, y)
      if expected ~= nil and picture:stencil(x, y) ~= (expected and 1 or 0) then wrong = wrong + 1 end
    end
  end
  expect(wrong > 1000, "only " .. wrong .. " pixels are wrong")
  naive("divided by w before GL clips: " .. wrong .. " pixels are wrong", picture)
end)

-- ---- 4: the plane's sign

test("the_plane_s_sign_changes_nothing", function()
  for _, plane in ipairs{ ground, oblique } do
    for _, light in ipairs{ lamp, vec4(toward, 0) } do
      expect_equal(shadow.planar(-plane, light), shadow.planar(plane, light))
      expect_equal(shadow.plane_toward(-plane, light), shadow.plane_toward(plane, light))
    end
  end
  local turned = footprint(block, shadow.planar(-ground, lamp))
  expect(count(turned) > 1000)
  ours("the same matrix, number by number", turned)
end)

test("the_slide_s_matrix_loses_the_shadow_where_p_l_is_negative", function()
  expect(count(footprint(block, slide(ground, lamp))) > 1000)
  local lost = footprint(block, slide(-ground, lamp))
  expect_equal(count(lost), 0)
  naive("the shadow is gone", lost)
end)

-- ---- 5: below the plane, above the light

local clipping = { "projected_stencil", "projected_offset", "projected_textured" }

test("a_caster_on_the_other_side_of_the_plane_throws_no_shadow", function()
  for _, recipe in ipairs(clipping) do
    local picture = render(recipe, { set = { light = "2,-2,1" } })
    local dark = picture.passes[#picture.passes - 1]
    expect_equal(picture:pass(dark):difference(picture:pass(1)).differing, 0, recipe)
  end
end)

test("a_caster_above_the_light_throws_no_shadow", function()
  for _, recipe in ipairs(clipping) do
    -- The teapot stands from 0.35 to 1.35.
    local picture = render(recipe, { set = { light = "2,0.3,1" } })
    local dark = picture.passes[#picture.passes - 1]
    expect_equal(picture:pass(dark):difference(picture:pass(1)).differing, 0, recipe)
  end
end)

test("of_a_caster_across_the_plane_the_part_above_throws_the_shadow", function()
  -- From the light (4, 4, 0) the upper corners, at height 1, land at L + (v - L) · 4/3; between them
  -- and the wall's trace in the plane is the shadow.
  local corners = { vec3(0, 0, -1), vec3(0, 0, 1), vec3(-4 / 3, 0, 4 / 3), vec3(-4 / 3, 0, -4 / 3) }
  local sunk = scene.load "sunk"
  local viewer = analytic.viewer(sunk.camera, size, size)
  local hull = analytic.window_hull(viewer, corners)
  local ground_hull = analytic.window_hull(viewer, { vec3(-4, 0, -3), vec3(4, 0, -3), vec3(4, 0, 3),
                                                     vec3(-4, 0, 3) })
  local stencil = render("planar_shadow", { scene = "sunk", size = { size, size },
                                            set = { light = "4,4,0" } }):pass(2)
  local inside = 0
  for y = 0, size - 1 do
    for x = 0, size - 1 do
      local side = analytic.side(hull, x, y)
      if side and analytic.side(ground_hull, x, y) == "in" then
        if side == "in" then inside = inside + 1 end
        expect_equal(stencil:stencil(x, y), side == "in" and 0 or 1, x .. ", " .. y)
      end
    end
  end
  expect(inside > 1000)
end)

test("the_slide_s_matrix_projects_what_is_below_the_plane", function()
  local below = footprint(wall(-1, -0.1), slide(ground, lamp))
  expect(count(below) > 100)
  naive(count(below) .. " pixels of an anti-shadow, of what is below the plane",
        footprint(wall(-1, 1), slide(ground, lamp)))
end)

test("cut_off_at_the_plane_a_caster_throws_the_shadow_of_its_part_above", function()
  local function cut(caster)
    return stencilled(function()
      gl.Enable(gl.CLIP_DISTANCE0)
      caster:draw(shader.load "planar", { view = camera:view(), projection = camera:projection(1),
                                          model = shadow.planar(ground, lamp), above = ground })
    end)
  end
  expect_equal(count(cut(wall(-1, -0.1))), 0)
  local across = cut(wall(-1, 1))
  expect_equal(across:difference(footprint(wall(0, 1), slide(ground, lamp))).stencil, 0)
  ours("0 pixels of the part below", across)
end)

-- ---- 6: far from the origin

local function moved(name, offset)
  return render("planar_shadow", { scene = name, size = { size, size },
                                   set = { light = vec3(2, 4, 1) + offset } })
end

-- At 1e6 the shadow's matrix errs by 1e-5 (shadow/planar.h) and a pixel is 0.02 wide, so places agree
-- to a thousandth of a pixel: of the outlines' 1,500 pixels about 3 have the outline that near to their
-- centres, and those alone may differ. (Measured: none.)
test("a_world_far_from_the_origin_draws_the_same_picture", function()
  local here = moved("moved_0", vec3(0))
  for name, distance in pairs{ moved_1e3 = 1e3, moved_1e5 = 1e5, moved_1e6 = 1e6 } do
    local there = moved(name, vec3(1, 0.7, -1 / 3) * distance)
    local difference = here:difference(there)
    expect(difference.differing <= 3, name .. ": " .. difference.differing .. " pixels differ")
    expect(difference.stencil <= 3, name .. ": " .. difference.stencil .. " stencil values differ")
  end
end)

-- The listing with the matrices multiplied in the shader, in float, as a first program does it; and in
-- double, before they are handed to it.
test("in_float_the_shadow_is_lost_on_the_way", function()
  local world = scene.load "table"
  local teapot, projection = world:object "teapot", world.camera:projection(1)
  local multiplying = shader.compile{
    vertex = [[#version 330 core
      layout(location = 0) in vec3 position;
      uniform mat4 to_eye, to_plane, to_world, to_clip;
      void main() { gl_Position = to_clip * (to_eye * (to_plane * (to_world * vec4(position, 1.0)))); }]],
    fragment = [[#version 330 core
      out vec4 fragment;
      void main() { fragment = vec4(1.0); }]] }
  local function pictures(distance)
    local offset = vec3(1, 0.7, -1 / 3) * distance
    local to_eye = world.camera:view() * mat4.translate(-offset)
    local to_plane = slide(vec4(0, 1, 0, -offset.y), vec4(vec3(2, 4, 1) + offset, 1))
    local to_world = mat4.translate(offset) * teapot.model
    return stencilled(function()
      teapot:draw(multiplying, { to_eye = to_eye, to_clip = projection, to_plane = to_plane, to_world = to_world })
    end), stencilled(function()
      teapot:draw(shader.load "flat", { view = to_eye, projection = projection, model = to_plane * to_world,
                                        color = vec3(1) })
    end)
  end
  local here = pictures(0)
  local function differing(distance) return here:difference((pictures(distance))).stencil end
  local near, far, farther = differing(1e3), differing(1e5), differing(1e6)
  expect(near > 10, "at 1e3")
  -- The shadow has 3,000 pixels: it is gone, or somewhere else.
  expect(far > 2000, "at 1e5")
  expect(farther > 2000, "at 1e6")
  local in_float, in_double = pictures(1e6)
  naive(string.format("with matrices multiplied in float %d pixels of the shadow differ at 1e3, %d at 1e6",
                      near, farther), in_float)
  local wrong = here:difference(in_double).stencil
  expect(wrong <= 3, wrong .. " pixels differ at 1e6 in double")
  ours("at 1e6 " .. wrong .. " pixels differ", in_double)
end)

-- ---- 7: the light crosses the plane of a face

test("the_light_crossing_a_face_s_plane_changes_the_coverage_without_a_jump", function()
  local a, b, c, d = vec3(-1, 1, -1), vec3(1, 1, -1), vec3(0, 1, 1), vec3(0, 2.5, 0)
  local caster = mesh.new{ positions = { a, b, c, d }, indices = { 0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0 } }
  for _, face in ipairs{ { a, d, b }, { b, d, c }, { c, d, a } } do
    local normal = (face[2] - face[1]):cross(face[3] - face[1]):normalize()
    local on_face = (face[1] + face[2] + face[3]) / 3 + vec3(0, 1, 0):cross(normal):normalize()
                    + (vec3(0, 1, 0) - normal * normal.y) * 3.5
    local before_area, before_count
    for step = -6, 6 do
      local light = vec4(on_face + normal * step / 30, 1)
      local picture = footprint(caster, shadow.planar(ground, light))
      local hull = analytic.window_hull(viewer, images(caster, ground, light))
      local area, outline = 0, 0
      for i, p in ipairs(hull) do
        local q = hull[i % #hull + 1]
        area = area + (p.x * q.y - p.y * q.x) / 2
        outline = outline + p:distance(q)
      end
      for y = 0, size - 1 do
        for x = 0, size - 1 do
          local side = analytic.side(hull, x, y)
          if side then expect_equal(picture:stencil(x, y), side == "in" and 1 or 0) end
        end
      end
      local covered = count(picture)
      expect_near(covered, area, outline / 2, "of a pixel on the outline at most half is miscounted "
                                              .. "on average")
      if before_area then
        expect(math.abs(covered - before_count) <= math.abs(area - before_area) + outline / 2)
        expect(math.abs(area - before_area) < 0.1 * area, "the hull itself jumps")
      end
      before_area, before_count = area, covered
      if step == 0 and face[1] == a and face[2] == d then
        ours("the light in the face's plane: " .. covered .. " pixels of an area of " .. area // 1, picture)
      end
    end
  end
end)

row{ case = 1, title = "A light at infinity", expected = "w = 0 is the directional matrix exactly; at a distance D it is off by O(1/D)",
     facts = { "a_light_at_infinity_is_the_directional_matrix", "at_a_distance_d_the_shadow_is_off_by_one_over_d",
               "a_light_far_enough_draws_the_directional_shadow" },
     without = "right too: the slide's matrix has the light's w in it" }
row{ case = 2, title = "The light in the plane", expected = "P·L = 0 is said to be singular; nothing that is not a number reaches a picture",
     facts = { "a_light_in_the_plane_is_refused_in_one_sentence", "the_slide_s_matrix_throws_everything_into_the_light_there",
               "a_light_next_to_the_plane_draws_nothing_that_is_not_a_number" } }
row{ case = 3, title = "A vertex at the light's height", expected = "w' = 0: a shadow without an end, and no wrap-around",
     facts = { "a_vertex_at_the_light_s_height_throws_a_shadow_without_an_end",
               "what_is_above_the_light_adds_nothing_and_does_not_wrap_around", "dividing_by_w_first_wraps_around" } }
row{ case = 4, title = "The plane's sign", expected = "the same image for P and -P",
     facts = { "the_plane_s_sign_changes_nothing", "the_slide_s_matrix_loses_the_shadow_where_p_l_is_negative" } }
row{ case = 5, title = "A caster below the plane, or above the light", expected = "no shadow on the plane",
     facts = { "a_caster_on_the_other_side_of_the_plane_throws_no_shadow", "a_caster_above_the_light_throws_no_shadow",
               "of_a_caster_across_the_plane_the_part_above_throws_the_shadow", "the_slide_s_matrix_projects_what_is_below_the_plane",
               "cut_off_at_the_plane_a_caster_throws_the_shadow_of_its_part_above" } }
row{ case = 6, title = "A world far from the origin", expected = "moved by 1e3, 1e5, 1e6 units: the image at the origin",
     facts = { "a_world_far_from_the_origin_draws_the_same_picture", "in_float_the_shadow_is_lost_on_the_way" } }
row{ case = 7, title = "The light crossing the plane of a face", expected = "the coverage is the hull's area, and changes without a jump",
     facts = { "the_light_crossing_a_face_s_plane_changes_the_coverage_without_a_jump" },
     without = "right too: a projected caster has no silhouette that could be found wrongly" }
