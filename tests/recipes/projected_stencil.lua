-- The recipe against the shadow computed by hand, and against rays.
local analytic = require "analytic"
local by_hand = require "by_hand"

local darkness = 0.35  -- the recipe's

test("the_shadow_is_the_quadrilateral_computed_by_hand", function()
  local stencil = by_hand.render("projected_stencil", by_hand.light):pass(2)
  by_hand.each_pixel(by_hand.shadow, function(x, y, what, in_shadow)
    if what ~= "receiver" then return end
    expect_equal(stencil:stencil(x, y), in_shadow and 0 or 1, x .. ", " .. y)
  end)
end)

-- Two of the caster's faces, and more where they overlap, are projected onto most of the shadow.
test("a_pixel_in_shadow_is_darkened_once", function()
  local picture = by_hand.render("projected_stencil", by_hand.light)
  by_hand.each_pixel(by_hand.shadow, function(x, y, what, in_shadow)
    if what ~= "receiver" or not in_shadow then return end
    expect_equal(analytic.rgb(picture, x, y), analytic.levels(by_hand.plane_color * darkness),
                 x .. ", " .. y)
  end)
end)

test("a_lit_pixel_has_the_reflection_model_s_colour", function()
  local picture = by_hand.render("projected_stencil", by_hand.light)
  by_hand.each_pixel(by_hand.shadow, function(x, y, what, in_shadow, viewer)
    if what ~= "receiver" or in_shadow then return end
    local point = analytic.on_plane(viewer, by_hand.plane, x, y)
    local color = analytic.phong(viewer, point, vec3(0, 1, 0), by_hand.light, by_hand.plane_color,
                                 darkness)
    expect_near(analytic.rgb(picture, x, y), analytic.levels(color), 1,
                "the shader computes in float, so what is halfway between two steps of 8 bits may "
                .. "round either way")
  end)
end)

test("the_shadow_ends_at_the_receiver_s_edge", function()
  local picture = by_hand.render("projected_stencil", by_hand.low_light)
  local stencil = picture:pass(2)
  by_hand.each_pixel(by_hand.low_shadow, function(x, y, what, in_shadow)
    if what == "receiver" then
      expect_equal(stencil:stencil(x, y), in_shadow and 0 or 1)
    elseif what == "background" then
      expect_equal(stencil:stencil(x, y), 0)
      expect_equal(analytic.rgb(picture, x, y), analytic.levels(by_hand.background))
    end
  end)
end)

test("the_caster_is_drawn_over_its_shadow", function()
  local picture = by_hand.render("projected_stencil", by_hand.light)
  local before = picture:pass(3)
  by_hand.each_pixel(by_hand.shadow, function(x, y, what)
    if what == "caster" then expect(picture:depth(x, y) < before:depth(x, y)) end
  end)
end)

test("each_wall_of_the_room_is_marked_with_its_number", function()
  local size = 256
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

-- 1 or 0 where the ray-traced visibility of a pixel and its eight neighbours is; else nil: an edge.
local function truth_around(truth, x, y)
  local value = truth:color(x, y)
  for dy = -1, 1 do
    for dx = -1, 1 do
      if truth:color(x + dx, y + dy) ~= value then return nil end
    end
  end
  return value == 255 and 1 or 0
end

-- Expects of each pixel of a receiver, a pixel or more from every edge, that the stencil tells light
-- from shadow as tracing rays does.
local function expect_truth(scene_name, light)
  local size = 512  -- shadow.truth's
  local picture = render("projected_stencil",
                         { scene = scene_name, size = { size, size }, set = { light = light } })
  local truth = frame(size, size, function()
    local world = scene.load(scene_name)
    gl.BindTexture(gl.TEXTURE_2D, shadow.truth(world, world.camera, vec4(light, 1)))
    local show = shader.compile{
      vertex = [[#version 330 core
        layout(location = 0) in vec3 position;
        void main() { gl_Position = vec4(position, 1.0); }]],
      fragment = [[#version 330 core
        uniform sampler2D image;
        out vec4 fragment;
        void main() { fragment = vec4(texelFetch(image, ivec2(gl_FragCoord.xy), 0).r); }]] }
    mesh.quad():draw(show)
  end)
  local receivers = picture:pass(3)
  local stencil = picture:pass(2)
  local counts = { [0] = 0, 0 }
  for y = 1, size - 2 do
    for x = 1, size - 2 do
      local expected = receivers:depth(x, y) < 1 and truth_around(truth, x, y)
      for dy = -1, 1 do
        for dx = -1, 1 do
          -- A caster is in front.
          local here = picture:depth(x + dx, y + dy)
          if here < receivers:depth(x + dx, y + dy) or here == 1 then expected = nil end
        end
      end
      if expected then
        counts[expected] = counts[expected] + 1
        expect_equal(stencil:stencil(x, y) > 0 and 1 or 0, expected, x .. ", " .. y)
      end
    end
  end
  expect(counts[0] > 2000 and counts[1] > 20000, "hardly a pixel is compared")
end

test("on_the_table_light_and_shadow_are_where_rays_find_them", function()
  expect_truth("table", vec3(2, 4, 1))
end)

test("in_the_room_a_shadow_is_clipped_to_the_wall_that_it_falls_on", function()
  expect_truth("room", vec3(0.2, 2.1, 0.9))
end)
