-- Cascades where numbers are hard: a camera that moves by less than a texel, and splits at the ends of λ.
local map_pass = require "parts.map_pass"

-- A map's depths, row by row.
local function depths_of(world, map, size)
  local depths
  frame(size, size, function(r)
    local target, texture = map_pass.make(size)
    map_pass.draw(r, target, size, world.caster, shader.load "flat", map.view, map.projection)
    gl.BindFramebuffer(gl.READ_FRAMEBUFFER, target)
    depths = gl.ReadPixels(0, 0, size, size, gl.DEPTH_COMPONENT, gl.FLOAT)
    gl.BindFramebuffer(gl.READ_FRAMEBUFFER, 0)
    -- Maps of one picture are of no use to the next, and their memory is counted.
    gl.DeleteFramebuffers(1, target)
    gl.DeleteTextures(1, texture)
  end)
  return depths
end

-- Which texels that both maps have differ, the second having moved by whole texels: how many, and 1 for
-- each of them, row by row of the second. A map that stayed is the same to the bit; in one that moved the
-- rasterizer interpolates depth from another corner of the window, in floats, which here rounds by up to
-- six of the 2^24 steps. No texel changes what covers it.
local function changed(a, b, size, dx, dy)
  local count, which, rounding = 0, {}, (dx ~= 0 or dy ~= 0) and 8 * 2 ^ -24 or 0
  for i = 1, size * size do which[i] = 0 end
  for y = math.max(0, dy), math.min(size, size + dy) - 1 do
    for x = math.max(0, dx), math.min(size, size + dx) - 1 do
      if math.abs(a[(y - dy) * size + x - dx + 1] - b[y * size + x + 1]) > rounding then
        count = count + 1
        which[y * size + x + 1] = 1
      end
    end
  end
  return count, which
end

-- A map's values as a picture: black is 0, white 1.
local function shown(values, size)
  return frame(size, size, function()
    local map = gl.GenTextures(1)
    gl.BindTexture(gl.TEXTURE_2D, map)
    gl.TexImage2D(gl.TEXTURE_2D, 0, gl.R32F, size, size, 0, gl.RED, gl.FLOAT, values)
    gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST)
    mesh.quad():draw(shader.compile{
      vertex = "#version 330 core\nlayout(location = 0) in vec3 position;\nvoid main() { gl_Position = vec4(position, 1.0); }",
      fragment = [[#version 330 core
        uniform sampler2D map;
        out vec4 fragment;
        void main() { fragment = vec4(texelFetch(map, ivec2(gl_FragCoord.xy), 0).rrr, 1.0); }]] }, { map = 0 })
    gl.DeleteTextures(1, map)
  end)
end

-- Half a texel is the farthest that a step can be from a whole one: within it, the map either stays or
-- moves by one.
test("a_sub_texel_move_of_the_camera_changes_no_texel_of_a_stable_map", function()
  local world, light, size = scene.load "city", vec4(0.7, 0.75, 0.3, 0), 256
  local function maps(camera, stable)
    return shadow.cascades(camera, light, 3, { lambda = 0.8, stable = stable, size = size, far = 120 })
  end
  local first = maps(world.camera, true)
  local moved, stayed, tight_changes = 0, 0, 0
  local stable_map, tight_map
  for i, map in ipairs(first) do
    local before = depths_of(world, map, size)
    local texel = 2 / (map.projection[1][1] * size)
    for step = 1, 12 do
      local camera = world.camera:moved(vec3(0.31, 0.02, -0.37):normalize() * (step / 12 * texel))
      local after = maps(camera, true)[i]
      local shift = (after.projection * after.view - map.projection * map.view):column(4) * (size / 2)
      local dx, dy = math.floor(shift.x + 0.5), math.floor(shift.y + 0.5)
      if dx ~= 0 or dy ~= 0 then moved = moved + 1 else stayed = stayed + 1 end
      local count, which = changed(before, depths_of(world, after, size), size, dx, dy)
      expect_equal(count, 0, "map " .. i .. ", " .. step .. "/12 of a texel")
      if step == 6 then stable_map = which end
    end
    -- The tight map, for comparison.
    local tight = maps(world.camera, false)[i]
    local swum = maps(world.camera:moved(vec3(0.31, 0.02, -0.37):normalize() * texel / 2), false)[i]
    local count, which = changed(depths_of(world, tight, size), depths_of(world, swum, size), size, 0, 0)
    tight_changes, tight_map = tight_changes + count, which
  end
  expect(moved > 0 and stayed > 0, moved .. " moved, " .. stayed .. " stayed")
  expect(tight_changes > 100, "a tight map hardly changes: " .. tight_changes)
  naive("of tight maps " .. tight_changes .. " texels change", shown(tight_map, size))
  ours("0 texels change", shown(stable_map, size))
end)

test("splits_are_uniform_at_lambda_0_and_logarithmic_at_1_and_finite_for_a_million", function()
  local uniform, logarithmic = shadow.split_distances(1, 9, 4, 0), shadow.split_distances(1, 16, 4, 1)
  for i = 0, 4 do
    expect_equal(uniform[i + 1], 1 + 2 * i)
    expect_near(logarithmic[i + 1], 2 ^ i, 1e-14, "pow, rounded")
  end
  for _, lambda in ipairs { 0, 0.5, 1 } do
    local z = shadow.split_distances(1e-3, 1e3, 4, lambda)
    for i = 2, #z do expect(z[i] > z[i - 1] and z[i] < math.huge) end
  end
end)

row{ case = 18, title = "A sub-texel move of the camera", expected = "0 texels of a stable map change",
     facts = { "a_sub_texel_move_of_the_camera_changes_no_texel_of_a_stable_map" } }
row{ case = 19, title = "Splits at λ = 0 and 1, near = far/1e6", expected = "the uniform and the logarithmic split; finite",
     facts = { "splits_are_uniform_at_lambda_0_and_logarithmic_at_1_and_finite_for_a_million" },
     without = "right too: the formula itself is finite" }
