-- What a depth buffer can tell apart with near = 0.1 and far = 100,000. Window depth is 1 - n/z, but for
-- a part in 10^6, so a step of 2^-bits of it is z²/(n · 2^bits) metres: 0.6 m at 1 km with 24 bits. A
-- float is no better: near 1 its steps are 2^-24 too. Reversed, depth is n/z under a clip range from 0
-- to 1, and near 0 a float's steps are in proportion to it: 2^-24 z to 2^-23 z metres.
local near, far, columns = 0.1, 1e5, 256

local vertex = [[
#version 330 core
layout(location = 0) in vec3 position;
uniform float from;
uniform float range;
uniform vec2 depth_of;   // clip z = x · distance + y
void main() {
  float distance = from + range * position.z;
  gl_Position = vec4(position.xy * distance, depth_of.x * distance + depth_of.y, distance);
}]]
local fragment = "#version 330 core\nvoid main() {}"

-- Quads side by side, each at a distance of its own: z from 0 to 1.
local function steps()
  local positions, indices = {}, {}
  for i = 0, columns - 1 do
    local first = #positions
    for _, corner in ipairs { { 0, -1 }, { 1, -1 }, { 1, 1 }, { 0, 1 } } do
      positions[#positions + 1] = vec3(2 * (i + corner[1]) / columns - 1, corner[2], i / (columns - 1))
    end
    for _, k in ipairs { 0, 1, 2, 0, 2, 3 } do indices[#indices + 1] = first + k end
  end
  return mesh.new { positions = positions, indices = indices }
end

-- z²/(n · 2^bits) over the 64 steps from `z` on, by which z grows.
local function expected_step(z, bits)
  local first = z * z / (near * 2 ^ bits)
  return 64 * first / (near * 2 ^ bits * (1 / z - 1 / (z + 64 * first)))
end

-- Clip z over distance; reversed, from 1 at the near plane to 0, which GL is told.
local function depth_of(reversed)
  if not reversed then return vec2((far + near) / (far - near), -2 * far * near / (far - near)) end
  gl.ClipControl(gl.LOWER_LEFT, gl.ZERO_TO_ONE)
  return vec2(-near / (far - near), far * near / (far - near))
end

-- The step between depths that differ, in metres, from `distance` on, over 64 times `expected`.
local function measured(format, reversed, distance, expected)
  local found
  frame(columns, 1, function()
    local map = gl.GenTextures(1)
    gl.BindTexture(gl.TEXTURE_2D, map)
    gl.TexImage2D(gl.TEXTURE_2D, 0, format, columns, 1, 0, gl.DEPTH_COMPONENT, gl.FLOAT, nil)
    gl.BindFramebuffer(gl.FRAMEBUFFER, gl.GenFramebuffers(1))
    gl.FramebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.TEXTURE_2D, map, 0)
    gl.DrawBuffer(gl.NONE)
    gl.ReadBuffer(gl.NONE)
    gl.Enable(gl.DEPTH_TEST)
    gl.DepthFunc(gl.ALWAYS)
    local range = 64 * expected
    steps():draw(shader.compile { vertex = vertex, fragment = fragment },
                 { from = distance, range = range, depth_of = depth_of(reversed) })
    local seen, differing = {}, 0
    for _, depth in ipairs(gl.ReadPixels(0, 0, columns, 1, gl.DEPTH_COMPONENT, gl.FLOAT)) do
      if not seen[depth] then differing = differing + 1 end
      seen[depth] = true
    end
    found = range / (differing - 1)
  end)
  return found
end

local reason = "64 steps are drawn over, whose first and last are cut, and depths are computed in floats"

test("depth_16_resolves_z_squared_over_n_2_to_the_16", function()
  for _, z in ipairs { 2, 10, 50 } do
    local expected = z * z / (near * 2 ^ 16)
    expect_near(measured(gl.DEPTH_COMPONENT16, false, z, expected) / expected_step(z, 16), 1, 0.05, reason)
  end
end)

test("depth_24_and_a_float_of_32_bits_resolve_the_same", function()
  for _, z in ipairs { 100, 300, 1000 } do
    local expected = z * z / (near * 2 ^ 24)
    for _, format in ipairs { gl.DEPTH_COMPONENT24, gl.DEPTH_COMPONENT32F } do
      expect_near(measured(format, false, z, expected) / expected_step(z, 24), 1, 0.1, reason)
    end
  end
  naive(string.format("at 1000 m D24 tells %.2f m apart and D32F %.2f m",
                      measured(gl.DEPTH_COMPONENT24, false, 1000, 1e6 / (near * 2 ^ 24)),
                      measured(gl.DEPTH_COMPONENT32F, false, 1000, 1e6 / (near * 2 ^ 24))))
end)

-- Distances are floats too, whose own steps are at most 2^-23 of them.
test("a_reversed_float_resolves_a_constant_part_of_the_distance", function()
  for _, z in ipairs { 100, 1000, 10000 } do
    local relative = measured(gl.DEPTH_COMPONENT32F, true, z, z * 2 ^ -23) / z
    expect(relative >= 2 ^ -24.2 and relative <= 2 ^ -22, z .. ": " .. relative * 2 ^ 24 .. " · 2^-24")
    if z == 1000 then ours(string.format("reversed, D32F tells %.2g m apart at 1000 m", relative * z)) end
  end
end)

-- What is seen: a white slope from 995 m to 1005 m and, 0.3 m behind it, a black one, drawn last. The black
-- one passes where its depth is rounded to the white one's. How many pixels that are.
local function slopes(format, reversed)
  local behind = 0
  local picture = frame(columns, columns, function(r)
    local map, colors, target = gl.GenTextures(1), gl.GenRenderbuffers(1), gl.GenFramebuffers(1)
    gl.BindTexture(gl.TEXTURE_2D, map)
    gl.TexImage2D(gl.TEXTURE_2D, 0, format, columns, columns, 0, gl.DEPTH_COMPONENT, gl.FLOAT, nil)
    gl.BindRenderbuffer(gl.RENDERBUFFER, colors)
    gl.RenderbufferStorage(gl.RENDERBUFFER, gl.RGBA8, columns, columns)
    gl.BindFramebuffer(gl.FRAMEBUFFER, target)
    gl.FramebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.TEXTURE_2D, map, 0)
    gl.FramebufferRenderbuffer(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.RENDERBUFFER, colors)
    gl.Enable(gl.DEPTH_TEST)
    gl.DepthFunc(reversed and gl.GEQUAL or gl.LEQUAL)
    gl.ClearDepth(reversed and 0 or 1)
    gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
    local painted = shader.compile { vertex = vertex, fragment = [[
      #version 330 core
      uniform vec3 color;
      out vec4 fragment;
      void main() { fragment = vec4(color, 1.0); }]] }
    for _, slope in ipairs { { 995, vec3(1) }, { 995.3, vec3(0) } } do
      steps():draw(painted, { from = slope[1], range = 10, depth_of = depth_of(reversed), color = slope[2] })
    end
    gl.BindFramebuffer(gl.DRAW_FRAMEBUFFER, 0)
    gl.BlitFramebuffer(0, 0, columns, columns, 0, 0, columns, columns, gl.COLOR_BUFFER_BIT, gl.NEAREST)
  end)
  for x = 0, columns - 1 do
    if (picture:color(x, columns // 2)) == 0 then behind = behind + 1 end
  end
  return behind, picture
end

-- Steps of 0.6 m do not tell 0.3 m apart in half of the columns; depths are computed in floats, which
-- makes it a few more or less.
test("what_is_a_foot_behind_a_surface_at_a_kilometre_is_seen_through_it_but_for_reversed_depths", function()
  for _, format in ipairs { gl.DEPTH_COMPONENT24, gl.DEPTH_COMPONENT32F } do
    local behind, picture = slopes(format, false)
    expect(behind > columns / 4, behind)
    if format == gl.DEPTH_COMPONENT24 then naive(behind .. " of " .. columns .. " columns show what is 0.3 m behind", picture) end
  end
  local behind, picture = slopes(gl.DEPTH_COMPONENT32F, true)
  expect_equal(behind, 0)
  ours("no column shows what is 0.3 m behind", picture)
end)

row{ case = 8, title = "Near and far 0.1 and 1e5", expected = "steps of z²/(n · 2^bits); reversed D32F a constant part of the distance",
     facts = { "depth_16_resolves_z_squared_over_n_2_to_the_16", "depth_24_and_a_float_of_32_bits_resolve_the_same",
               "a_reversed_float_resolves_a_constant_part_of_the_distance",
               "what_is_a_foot_behind_a_surface_at_a_kilometre_is_seen_through_it_but_for_reversed_depths" } }
