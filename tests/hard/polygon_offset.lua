-- The offset that the depth buffer shows is factor · m + r · units (OpenGL 4.5, section 14.6.5), with
-- m = max(|dz/dx|, |dz/dy|), as Mesa takes it, and r the implementation's.
local size = 64
local steps = 2 ^ 24 - 1       -- of the depth buffer, which stores z · steps, rounded
local resolution = 1 / steps

-- What is stored: reading gives the nearest float, which tells all of them apart.
local function stored(picture, x, y) return math.floor(picture:depth(x, y) * steps + 0.5) end

-- A quad over the picture with window depth 0.5 + a (x - 32) + b (y - 32), x and y in pixels; its
-- vertices are in clip space, w = 1.
local function sloped(a, b)
  local corners, indices = {}, { 0, 1, 2, 0, 2, 3 }
  for i, corner in ipairs{ { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } } do
    local x, y = corner[1], corner[2]
    corners[i] = vec3(x, y, 2 * (a * x + b * y) * size / 2)
  end
  return mesh.new{ positions = corners, indices = indices }
end

local function depth_of(quad, factor, units)
  return frame(size, size, function()
    gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
    gl.Enable(gl.DEPTH_TEST)
    gl.Enable(gl.POLYGON_OFFSET_FILL)
    gl.PolygonOffset(factor, units)
    quad:draw(shader.load "flat", { color = vec3(1) })
  end)
end

-- Calls visit with the offset of each pixel, in units of resolution.
local function each_offset(quad, factor, units, visit)
  local plain, moved = depth_of(quad, 0, 0), depth_of(quad, factor, units)
  for y = 0, size - 1 do
    for x = 0, size - 1 do
      visit(stored(moved, x, y) - stored(plain, x, y))
    end
  end
end

-- r in units of resolution: at least 1, so that depths differ; Mesa's is 2. One unit of rounding in a
-- thousand does not hide it.
local function measured_r()
  local r
  each_offset(sloped(0, 0), 0, 1000, function(offset) r = math.floor(offset / 1000 + 0.5) end)
  expect(r == 1 or r == 2, "r is " .. r .. " units of resolution")
  return r
end

test("units_count_in_steps_of_r_whatever_the_slope", function()
  local r = measured_r()
  for _, slope in ipairs{ { 0, 0 }, { 2 ^ -9, 0 }, { 2 ^ -8, -2 ^ -10 } } do
    local quad = sloped(table.unpack(slope))
    for _, units in ipairs{ -64, -2, -1, 1, 3, 1000 } do
      each_offset(quad, 0, units, function(offset)
        expect_near(offset, r * units, 1, "both depths are rounded to the resolution")
      end)
    end
  end
end)

test("a_plane_that_faces_the_viewer_is_not_moved_by_the_factor", function()
  local flat = sloped(0, 0)
  for _, factor in ipairs{ -100, -1, 1, 100 } do
    each_offset(flat, factor, 0, function(offset) expect_equal(offset, 0) end)
  end
end)

local function expect_factor(slopes, tolerance, reason)
  for _, slope in ipairs(slopes) do
    local a, b = table.unpack(slope)
    local quad, m = sloped(a, b), math.max(math.abs(a), math.abs(b))
    for _, factor in ipairs{ -3, -1, 0.5, 1, 8 } do
      each_offset(quad, factor, 0, function(offset)
        expect_near(offset, factor * m / resolution, tolerance, reason)
      end)
    end
  end
end

test("the_factor_counts_in_the_larger_slope", function()
  expect_factor({ { 2 ^ -8, 0 }, { 0, 2 ^ -8 }, { -2 ^ -8, 2 ^ -9 }, { 2 ^ -10, -2 ^ -9 },
                  { 2 ^ -8, 2 ^ -8 } },
                1, "both depths are rounded to the resolution")
end)

test("the_factor_counts_in_slopes_that_no_float_holds", function()
  expect_factor({ { 1 / 1000, 1 / 700 }, { -1 / 300, 1 / 999 }, { 3e-7, -2e-7 } },
                2, "both depths are rounded to the resolution, and interpolated in floats that near "
                   .. "1 are half as fine")
end)

test("factor_and_units_add_up", function()
  local r = measured_r()
  local a, b = 2 ^ -9, -2 ^ -8
  local quad = sloped(a, b)
  for _, case in ipairs{ { -1, -1 }, { 1, 1 }, { 1.5, -300 }, { -2, 7 } } do
    local factor, units = table.unpack(case)
    each_offset(quad, factor, units, function(offset)
      expect_near(offset, factor * 2 ^ -8 / resolution + r * units, 1,
                  "both depths are rounded to the resolution")
    end)
  end
end)

-- A plane in perspective: window depth is still affine in window x and y, so m is one number.
test("in_perspective_the_offset_is_the_same_all_over_the_plane", function()
  local projection = mat4.perspective(60, 1, 1, 20)
  local r = measured_r()
  for _, tilt in ipairs{ 30, 60, 80, 87 } do
    local model = mat4.translate(0, 0, -5) * mat4.rotate(tilt, 1, 0, 0)
    local function depth(x, y)
      -- The ray through the window point meets the plane; window depth from its eye z.
      local along = vec3((x / size * 2 - 1) / projection[1][1], (y / size * 2 - 1) / projection[2][2], -1)
      local normal = model:transform_direction(vec3(0, 0, 1))
      local z = -5 * normal.z / normal:dot(along) * along.z
      local clip = projection * vec4(0, 0, z, 1)
      return (clip.z / clip.w + 1) / 2
    end
    local m = math.abs(depth(32, 36) - depth(32, 28)) / 8
    local quad = mesh.quad()
    local function picture(factor, units)
      return frame(size, size, function()
        gl.Clear(gl.DEPTH_BUFFER_BIT)
        gl.Enable(gl.DEPTH_TEST)
        gl.Enable(gl.POLYGON_OFFSET_FILL)
        gl.PolygonOffset(factor, units)
        quad:draw(shader.load "flat", { projection = projection, model = model, color = vec3(1) })
      end)
    end
    local plain, moved = picture(0, 0), picture(-2, -3)
    local seen = 0
    for y = 0, size - 1 do
      for x = 0, size - 1 do
        if plain:depth(x, y) < 1 then
          seen = seen + 1
          local offset = stored(moved, x, y) - stored(plain, x, y)
          expect_near(offset, -2 * m / resolution - 3 * r, 1 + m / resolution / 100,
                      "both depths are rounded to the resolution; vertices to 1/256 of a pixel, "
                      .. "which over the plane's 20 pixels and more changes m by under 1/100")
        end
      end
    end
    expect(seen > 20, tilt .. " degrees: only " .. seen)
  end
end)

row{ case = 10, title = "Polygon offset", expected = "factor · m + r · units within one unit of resolution",
     facts = { "units_count_in_steps_of_r_whatever_the_slope", "a_plane_that_faces_the_viewer_is_not_moved_by_the_factor",
               "the_factor_counts_in_the_larger_slope", "the_factor_counts_in_slopes_that_no_float_holds",
               "factor_and_units_add_up", "in_perspective_the_offset_is_the_same_all_over_the_plane" },
     without = "right too: it is GL's own, measured" }
