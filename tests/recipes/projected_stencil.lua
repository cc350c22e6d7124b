-- The recipe on the scene whose shadow is computed by hand.
local analytic = require "analytic"

local size = 256
local light = vec4(4, 5, 2, 1)
local plane_color, background = vec3(0.74, 0.78, 0.72), vec3(0.85, 0.88, 0.92)
local darkness = 0.35

-- In the plane y = 0, by the similar triangles that scripts/scenes/tetra.lua gives.
local shadow_by_hand = { vec3(-2.25, 0, -1.75), vec3(0.25, 0, -1.75), vec3(-1, 0, 0.75),
                         vec3(-4, 0, -2) }
local receiver = { vec3(-5, 0, -3), vec3(3, 0, -3), vec3(3, 0, 3), vec3(-5, 0, 3) }
local caster = { vec3(-1, 1, -1), vec3(1, 1, -1), vec3(0, 1, 1), vec3(0, 2.5, 0) }

-- Calls visit(x, y, what) for each pixel that is a pixel or more from every edge: what is "caster",
-- "shadow", "lit" or "background".
local function each_pixel(points, visit)
  local viewer = analytic.viewer(scene.load("tetra").camera, size, size)
  local caster_hull = analytic.window_hull(viewer, caster)
  local receiver_hull = analytic.window_hull(viewer, receiver)
  local shadow_hull = analytic.window_hull(viewer, points)
  local counts = { caster = 0, shadow = 0, lit = 0, background = 0 }
  for y = 0, size - 1 do
    for x = 0, size - 1 do
      local on_caster = analytic.side(caster_hull, x, y)
      local on_receiver = analytic.side(receiver_hull, x, y)
      local in_shadow = analytic.side(shadow_hull, x, y)
      local what
      if on_caster == "in" then
        what = "caster"
      elseif on_caster == "out" and on_receiver == "out" then
        what = "background"
      elseif on_caster == "out" and on_receiver == "in" and in_shadow then
        what = in_shadow == "in" and "shadow" or "lit"
      end
      if what then
        counts[what] = counts[what] + 1
        visit(x, y, what, viewer)
      end
    end
  end
  for what, count in pairs(counts) do expect(count > 300, "only " .. count .. " pixels " .. what) end
end

local function tetra(light_text)
  return render("projected_stencil",
                { scene = "tetra", size = { size, size }, set = { light = light_text } })
end

test("the_shadow_is_the_quadrilateral_computed_by_hand", function()
  local stencil = tetra("4,5,2"):pass(2)
  each_pixel(shadow_by_hand, function(x, y, what)
    if what == "shadow" then expect_equal(stencil:stencil(x, y), 0, x .. ", " .. y) end
    if what == "lit" then expect_equal(stencil:stencil(x, y), 1, x .. ", " .. y) end
  end)
end)

-- Two of the caster's faces, and more where they overlap, are projected onto most of the shadow.
test("a_pixel_in_shadow_is_darkened_once", function()
  local picture = tetra("4,5,2")
  each_pixel(shadow_by_hand, function(x, y, what)
    if what ~= "shadow" then return end
    expect_equal(analytic.rgb(picture, x, y), analytic.levels(plane_color * darkness), x .. ", " .. y)
  end)
end)

test("a_lit_pixel_has_the_reflection_model_s_colour", function()
  local picture = tetra("4,5,2")
  each_pixel(shadow_by_hand, function(x, y, what, viewer)
    if what ~= "lit" then return end
    local point = analytic.on_plane(viewer, vec4(0, 1, 0, 0), x, y)
    local color = analytic.phong(viewer, point, vec3(0, 1, 0), light, plane_color, darkness)
    expect_near(analytic.rgb(picture, x, y), analytic.levels(color), 1,
                "the shader computes in float, so what is halfway between two steps of 8 bits may "
                .. "round either way")
  end)
end)

-- The light is low: the apex's shadow is at 2 v - L = (-9, 0, 0), past the plane's edge at x = -5.
test("the_shadow_ends_at_the_receiver_s_edge", function()
  local picture = tetra("9,5,0")
  local points = {}
  for i, v in ipairs(caster) do points[i] = analytic.cast(vec4(0, 1, 0, 0), vec4(9, 5, 0, 1), v) end
  expect_equal(points[4], vec3(-9, 0, 0))
  local stencil = picture:pass(2)
  each_pixel(points, function(x, y, what)
    if what == "shadow" then
      expect_equal(stencil:stencil(x, y), 0)
    elseif what == "lit" then
      expect_equal(stencil:stencil(x, y), 1)
    elseif what == "background" then
      expect_equal(stencil:stencil(x, y), 0)
      expect_equal(analytic.rgb(picture, x, y), analytic.levels(background))
    end
  end)
end)

test("the_caster_is_drawn_over_its_shadow", function()
  local picture = tetra("4,5,2")
  local before = picture:pass(3)
  each_pixel(shadow_by_hand, function(x, y, what)
    if what == "caster" then expect(picture:depth(x, y) < before:depth(x, y)) end
  end)
end)

test("each_wall_of_the_room_is_marked_with_its_number", function()
  local room = scene.load "room"
  local viewer = analytic.viewer(room.camera, size, size)
  local marked = render("projected_stencil",
                        { scene = "room", size = { size, size }, set = { light = "0.2,2.1,0.9" } }):pass(1)
  -- Seen from within, no wall hides another.
  for number, wall in ipairs(room.receivers) do
    local corners = { wall.mesh.low, wall.mesh.high }
    corners[3] = vec3(corners[1].x, 0, corners[2].z)
    corners[4] = vec3(corners[2].x, 0, corners[1].z)
    for i, corner in ipairs(corners) do corners[i] = wall.model:transform_point(corner) end
    local hull = analytic.window_hull(viewer, corners)
    local pixels = 0
    for y = 0, size - 1 do
      for x = 0, size - 1 do
        if analytic.side(hull, x, y) == "in" then
          pixels = pixels + 1
          expect_equal(marked:stencil(x, y), number, wall.name)
        end
      end
    end
    expect(pixels > 1000, wall.name .. " is hardly seen")
  end
end)
