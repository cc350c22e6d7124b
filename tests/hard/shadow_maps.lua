-- Hard cases of shadow maps, each beside what the plain listing gives.
local map_pass = require "parts.map_pass"
local visibility = require "visibility"
local analytic = require "analytic"

local side = 128

-- The light from which the scene's plane is turned by `degrees`, to any side.
local function grazing(world, degrees, turn)
  local model, a, b = world:object("plane").model, math.rad(degrees), math.rad(turn)
  local light = vec3(math.sin(a) * math.cos(b), math.cos(a), math.sin(a) * math.sin(b))
  return vec4(model:transform_direction(light), 0)
end

-- Maps of one picture are of no use to the next, and their memory is counted.
local function forget(target, map)
  gl.DeleteFramebuffers(1, target)
  gl.DeleteTextures(1, map)
end

-- The map's answer alone: at 89.9 degrees shading could not tell lit from dark.
local lookup = { vertex = [[
#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 model_view;
uniform mat4 model_view_projection;
uniform mat3 normal_matrix;
uniform vec4 light;
uniform mat4 light_matrix;
uniform float normal_offset;
out vec4 shadow_coord;
out vec3 place;
void main() {
  vec3 eye_position = (model_view * vec4(position, 1.0)).xyz;
  vec3 n = normalize(normal_matrix * normal), to_light = normalize(light.xyz);
  n *= sign(dot(n, to_light));
  shadow_coord = light_matrix * vec4(eye_position + n * normal_offset * length(cross(n, to_light)), 1.0);
  place = eye_position;
  gl_Position = model_view_projection * vec4(position, 1.0);
}]], fragment = [[
#version 330 core
#include "receiver_plane.glsl"
in vec4 shadow_coord;
in vec3 place;
uniform vec4 light;
uniform sampler2D shadow_map;
uniform float reach;
out vec4 fragment;
void main() {
  vec4 c = shadow_coord;
  float depth = c.p - climb(receiver_slope(c, dFdx(c), dFdy(c)), vec2(reach));
  bool lit = depth <= texture(shadow_map, c.st).r || c.p > 1.0;
  // What is turned from the light is no question here.
  bool turned = dot(cross(dFdx(place), dFdy(place)), light.xyz) <= 0.0;
  fragment = vec4(vec3(lit || turned ? 1.0 : 0.0), 1.0);
}]] }

-- How many pixels of a scene are in shadow, and how many are seen, under a directional light; and the
-- picture.
local function shadowed(world, light, size, how)
  local camera = world.camera
  local view, projection = camera:view(), camera:projection(1)
  local light_view, light_projection = shadow.light_view(light, world, { fit = "scene" })
  local bias = shadow.map_bias(light_projection, size)
  local picture = frame(side, side, function(r)
    local target, map = map_pass.make(size)
    map_pass.draw(r, target, size, world.caster, shader.load "flat", light_view, light_projection,
                  { factor = (how.factor or 0) * bias.factor, units = how.factor and bias.units or 0 })
    gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
    gl.BindTexture(gl.TEXTURE_2D, map)
    world:draw(shader.compile(lookup), {
      view = view, projection = projection, light = light, shadow_map = 0,
      light_matrix = shadow.bias_matrix() * light_projection * light_view * view:inverse(),
      normal_offset = (how.normal or 0) * bias.normal_offset,
      reach = (how.climb or 0) * bias.reach,
    })
    forget(target, map)
  end)
  local dark, seen = 0, 0
  for y = 0, side - 1 do
    for x = 0, side - 1 do
      local value, _, _, alpha = picture:color(x, y)
      if alpha > 0 then seen = seen + 1 end
      if alpha > 0 and value == 0 then dark = dark + 1 end
    end
  end
  return dark, seen, picture, bias
end

local angles = { 0, 15, 45, 60, 75, 85, 89, 89.5, 89.9 }

test("with_the_recommended_offset_no_lit_plane_shadows_itself_up_to_89_9_degrees", function()
  local world = scene.load "tilted"
  for _, degrees in ipairs(angles) do
    for _, turn in ipairs { 0, 33, 77 } do
      for _, size in ipairs { 64, 333, 1024 } do
        local dark, seen = shadowed(world, grazing(world, degrees, turn), size, { factor = 1 })
        expect(seen > 3000, "the plane is hardly seen")
        expect_equal(dark, 0, degrees .. " degrees, turned " .. turn .. ", " .. size .. " texels")
      end
    end
  end
  local dark, seen, picture = shadowed(world, grazing(world, 75, 33), 333, { factor = 1 })
  ours(dark .. " of " .. seen .. " lit pixels in shadow", picture)
end)

-- Two lit planes and nothing else: a convex ridge, that no light which reaches both shadows, and a
-- trough open to the light. The ridge's steep side is the one that the map's own offset fails.
test("with_the_recommended_offsets_no_lit_plane_shadows_another_along_their_edge", function()
  local by_offset = 0
  for _, name in ipairs { "ridge", "trough" } do
    local world = scene.load(name)
    for _, degrees in ipairs(angles) do
      for _, turn in ipairs { 0, 33, 77 } do
        local light = grazing(world, degrees, turn)
        for _, size in ipairs { 64, 333 } do
          local dark, seen = shadowed(world, light, size, { factor = 1, climb = 1 })
          expect(seen > 3000, name .. " is hardly seen")
          expect_equal(dark, 0, name .. ", " .. degrees .. " degrees, turned " .. turn .. ", " .. size .. " texels")
          by_offset = by_offset + shadowed(world, light, size, { factor = 1 })
        end
      end
    end
  end
  expect(by_offset > 100, "the map's offset alone leaves " .. by_offset)
  naive("the map's offset alone leaves " .. by_offset .. " lit pixels in shadow")
  ours "0 lit pixels in shadow"
end)

test("with_the_recommended_normal_offset_neither", function()
  local world = scene.load "tilted"
  for _, degrees in ipairs(angles) do
    for _, turn in ipairs { 0, 33, 77 } do
      for _, size in ipairs { 64, 333, 1024 } do
        local dark = shadowed(world, grazing(world, degrees, turn), size, { normal = 1 })
        expect_equal(dark, 0, degrees .. " degrees, turned " .. turn .. ", " .. size .. " texels")
      end
    end
  end
end)

test("two_fifths_of_either_leave_acne_and_none_leaves_most", function()
  local world = scene.load "tilted"
  for _, degrees in ipairs { 45, 75, 85, 89 } do
    local none, seen, picture = shadowed(world, grazing(world, degrees, 33), 333, {})
    if degrees == 75 then naive("without an offset " .. none .. " of " .. seen .. " lit pixels in shadow", picture) end
    local half = shadowed(world, grazing(world, degrees, 33), 333, { factor = 0.4 })
    local half_normal = shadowed(world, grazing(world, degrees, 33), 333, { normal = 0.4 })
    expect(none > seen / 4, degrees .. ": " .. none .. " of " .. seen)
    expect(half > 0 and half < none, degrees .. ": " .. half)
    -- Under a grazing light the fitted map's texels are narrow where the plane is steep, and the offset,
    -- which counts their wider side, has room to spare.
    if degrees == 45 then expect(half_normal > 0 and half_normal < none, degrees .. ": " .. half_normal) end
  end
end)

-- The width of the lit strip between the wall's foot at x = 0 and its shadow, metres, along the middle
-- row of pixels, up to `length`.
local function gap(picture, world, length)
  local viewer = analytic.viewer(world.camera, side, side)
  local widest = 0
  for x = 0, side - 1 do
    local point = analytic.on_plane(viewer, vec4(0, 1, 0, 0), x, side // 2)
    if point.x > 0 and point.x < length and picture:color(x, side // 2) > 0 then
      widest = math.max(widest, point.x)
    end
  end
  return widest
end

-- The wall's lit side is turned from the light by θ with tan θ = cot(elevation) … so its depth is pushed
-- by factor · texel · tan θ, and a floor point at x is x / cos(elevation) behind it. Lookups are half a
-- texel off besides, which on the floor is texel / sin(elevation), and a pixel is counted whole. A fragment
-- of the floor takes off its own climb: as much, of a plane turned from the light by 90° - elevation.
test("the_gap_at_a_contact_is_at_most_the_bias", function()
  local world = scene.load "contact"
  local pixel = 2 * 9 * math.tan(math.rad(10)) / side
  for _, elevation in ipairs { 25, 45, 65 } do
    local e = math.rad(elevation)
    local length = 0.7 / math.tan(e)      -- the shadow of the wall's 1 metre is longer
    local light = vec4(-math.cos(e), math.sin(e), 0, 0)
    for _, size in ipairs { 128, 512 } do
      local _, _, by_offset, bias = shadowed(world, light, size, { factor = 1 })
      local most = bias.factor * bias.texel * math.tan(e) * math.cos(e) + bias.texel / math.sin(e) + pixel
      expect(gap(by_offset, world, length) <= most, elevation .. ", " .. size .. ": " .. gap(by_offset, world, length) .. ", at most " .. most)
      local _, _, by_both = shadowed(world, light, size, { factor = 1, climb = 1 })
      most = most + bias.factor * bias.texel / math.tan(e) * math.cos(e)
      expect(gap(by_both, world, length) <= most, elevation .. ", " .. size .. ": " .. gap(by_both, world, length) .. ", with both at most " .. most)
      local _, _, by_normal = shadowed(world, light, size, { normal = 1 })
      most = (bias.normal_offset + bias.texel) / math.sin(e) + pixel
      expect(gap(by_normal, world, length) <= most, elevation .. ", " .. size .. ": " .. gap(by_normal, world, length) .. ", at most " .. most)
      -- Peter Panning: a hundred times the offset, and the shadow comes off. (The floor climbs less than the
      -- wall does under a high light.)
      local _, _, off = shadowed(world, light, size, { factor = 100 })
      expect(gap(off, world, length) > gap(by_offset, world, length) + pixel, elevation .. ", " .. size)
      local _, _, climbed = shadowed(world, light, size, { factor = 1, climb = 400 })
      expect(gap(climbed, world, length) > gap(by_both, world, length) + pixel, elevation .. ", " .. size .. ", by climb")
    end
  end
end)

-- A ball of radius 1 around the light, with what is just inside of it lit and just outside in shadow, in
-- every direction around each of the 12 edges and 8 corners of the cube. Its 96 × 48 facets are within
-- 1 - cos(π/48) = 0.2 % of it, a texel's bias within 4 %.
local by_direction = { vertex = [[
#version 330 core
layout(location = 0) in vec3 position;
out vec2 place;
void main() { place = position.xy; gl_Position = vec4(position.xy, 0.0, 1.0); }
]], fragment = [[
#version 330 core
in vec2 place;
uniform samplerCubeShadow shadow_map;
uniform vec3 middle, across, along;
uniform float distance, near, far;
out vec4 fragment;
void main() {
  vec3 way = distance * normalize(middle + place.x * across + place.y * along);
  vec3 sizes = abs(way);
  float axis = max(max(sizes.x, sizes.y), sizes.z);
  fragment = vec4(vec3(texture(shadow_map, vec4(way, far * (axis - near) / ((far - near) * axis)))), 1.0);
}]] }

test("visibility_is_continuous_across_all_edges_and_corners_of_a_cube", function()
  local size, near, far = 64, 0.3, 4
  local places = {}
  for x = -1, 1 do
    for y = -1, 1 do
      for z = -1, 1 do
        local axes = math.abs(x) + math.abs(y) + math.abs(z)
        if axes >= 2 then places[#places + 1] = vec3(x, y, z) end
      end
    end
  end
  expect_equal(#places, 20)
  for _, filter in ipairs { gl.NEAREST, gl.LINEAR } do
    for _, middle in ipairs(places) do
      for _, case in ipairs { { 0.95, 255 }, { 1.05, 0 } } do
        local p = frame(64, 64, function(r)
          local target, cube = fbo.cube_depth(size)
          gl.BindTexture(gl.TEXTURE_CUBE_MAP, cube)
          gl.TexParameteri(gl.TEXTURE_CUBE_MAP, gl.TEXTURE_MIN_FILTER, filter)
          gl.TexParameteri(gl.TEXTURE_CUBE_MAP, gl.TEXTURE_MAG_FILTER, filter)
          gl.TexParameteri(gl.TEXTURE_CUBE_MAP, gl.TEXTURE_COMPARE_MODE, gl.COMPARE_REF_TO_TEXTURE)
          gl.TexParameteri(gl.TEXTURE_CUBE_MAP, gl.TEXTURE_COMPARE_FUNC, gl.LEQUAL)
          gl.BindFramebuffer(gl.FRAMEBUFFER, target)
          gl.Viewport(0, 0, size, size)
          gl.Enable(gl.DEPTH_TEST)
          local ball = mesh.sphere(1, 96, 48)
          for i, face in ipairs(shadow.cube_faces(vec4(0, 0, 0, 1), near, far)) do
            gl.FramebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT,
                                    gl.TEXTURE_CUBE_MAP_POSITIVE_X + i - 1, cube, 0)
            gl.Clear(gl.DEPTH_BUFFER_BIT)
            ball:draw(shader.load "flat", { view = face.view, projection = face.projection })
          end
          gl.BindFramebuffer(gl.FRAMEBUFFER, 0)
          gl.Viewport(0, 0, r.width, r.height)
          gl.Disable(gl.DEPTH_TEST)
          gl.Enable(gl.TEXTURE_CUBE_MAP_SEAMLESS)
          -- An edge along its whole length and six texels around it; a corner with six texels around it.
          local along = vec3(middle.x == 0 and 1 or 0, middle.y == 0 and 1 or 0, middle.z == 0 and 1 or 0)
          if along:length() == 0 then along = middle:cross(vec3(1, 0, 0)):normalize() * 0.1 end
          local across = middle:cross(along):normalize() * 0.1
          mesh.quad():draw(shader.compile(by_direction), {
            shadow_map = 0, middle = middle, across = across, along = along, distance = case[1],
            near = near, far = far })
          forget(target, cube)
        end)
        for y = 0, 63 do
          for x = 0, 63 do
            expect_equal((p:color(x, y)), case[2], tostring(middle) .. " at " .. x .. ", " .. y)
          end
        end
      end
    end
  end
end)

-- Against the truth, 1.5 pixels from any edge: outside of the map's frustum, and behind the light.
test("what_is_outside_of_the_map_or_behind_the_light_is_lit", function()
  for _, recipe in ipairs { "behind_copy", "behind_fbo", "behind_sampler", "behind_pcf" } do
    local p = visibility.render(recipe, "behind")
    local viewer = analytic.viewer(scene.load("behind").camera, visibility.size, visibility.size)
    local ceiling, outside = 0, 0
    for y = 0, visibility.size - 1 do
      for x = 0, visibility.size - 1 do
        local up = analytic.on_plane(viewer, vec4(0, 1, 0, -4), x, y)
        local down = analytic.on_plane(viewer, vec4(0, 1, 0, 0), x, y)
        if up and math.abs(up.x) < 14 and math.abs(up.z) < 7.5 then
          ceiling = ceiling + 1
          expect_equal((p:color(x, y)), 255, recipe .. ", ceiling at " .. x .. ", " .. y)
        -- The ball's cone meets the floor within 0.4 · 2 / sqrt(1 - 0.4²) = 0.87 of its middle.
        elseif down and math.abs(down.x) < 14 and math.abs(down.z) < 7.5 and down.xz:length() > 1.5
               and y < visibility.size * 0.3 then
          outside = outside + 1
          expect_equal((p:color(x, y)), 255, recipe .. ", floor at " .. x .. ", " .. y)
        end
      end
    end
    expect(ceiling > 500 and outside > 500, ceiling .. ", " .. outside)
    ours(recipe .. ": " .. ceiling + outside .. " pixels lit", p)
  end
end)

row{ case = 9, title = "A plane lit at grazing angles up to 89.9°", expected = "no lit pixel in shadow with the recommended offset, and a gap at contacts of at most that offset",
     facts = { "with_the_recommended_offset_no_lit_plane_shadows_itself_up_to_89_9_degrees",
               "with_the_recommended_offsets_no_lit_plane_shadows_another_along_their_edge",
               "with_the_recommended_normal_offset_neither", "two_fifths_of_either_leave_acne_and_none_leaves_most",
               "the_gap_at_a_contact_is_at_most_the_bias" } }
row{ case = 20, title = "A cube's edges and corners", expected = "visibility is continuous across all 12 edges and 8 corners",
     facts = { "visibility_is_continuous_across_all_edges_and_corners_of_a_cube" },
     without = "right too, by the nearest texel; a filter needs seamless cube maps" }
row{ case = 21, title = "Outside of the map, and behind the light", expected = "lit, never shadowed by a border or a negative w",
     facts = { "what_is_outside_of_the_map_or_behind_the_light_is_lit" },
     without = "right too: it sets the border; and the rim of a map that holds its casters is lit" }
