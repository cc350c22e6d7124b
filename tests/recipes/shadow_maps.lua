-- Shadow maps against the ray-traced truth, and against each other, at 128 × 128.
local visibility = require "visibility"

local hard = { "shadow_map_copy", "shadow_map_fbo", "shadow_map_sampler", "shadow_map_problems", "shadow_map_pcf" }

-- A texel's error is in proportion to its side: the area between the map's edge and the true one.
test("wrong_pixels_fall_as_the_map_grows", function()
  for _, recipe in ipairs(hard) do
    for _, name in ipairs { "table", "tetra", "cornell" } do
      local coarse = visibility.wrong(recipe, name, { size = 32 })
      local fine = visibility.wrong(recipe, name, { size = 1024 })
      expect(fine < coarse / 4, recipe .. ", " .. name .. ": " .. coarse .. " and " .. fine)
    end
  end
end)

-- Of the 16,384 pixels, those within half a texel of an edge; a larger number is a defect elsewhere.
test("at_1024_texels_hardly_a_pixel_is_wrong", function()
  for _, recipe in ipairs(hard) do
    for _, name in ipairs { "table", "tetra", "cornell" } do
      local wrong = visibility.wrong(recipe, name, { size = 1024 })
      expect(wrong <= 24, recipe .. ", " .. name .. ": " .. wrong)
    end
  end
end)

test("a_map_copied_in_pieces_is_the_one_drawn_into_a_framebuffer", function()
  for _, name in ipairs { "table", "cornell" } do
    local copied = visibility.render("shadow_map_copy", name, { size = 300 })
    local drawn = visibility.render("shadow_map_fbo", name, { size = 300 })
    expect_equal(copied:difference(drawn).differing, 0, name)
  end
end)

test("the_sampler_compares_as_the_shader_does", function()
  for _, name in ipairs { "table", "cornell", "tetra" } do
    local compared = visibility.render("shadow_map_sampler", name)
    local by_hand = visibility.render("shadow_map_fbo", name)
    expect_equal(compared:difference(by_hand).differing, 0, name)
  end
end)

local function compared(compare)
  return visibility.render("shadow_map_sampler", "table", { compare = compare, bias = "none" })
end

test("each_comparison_is_the_opposite_of_another", function()
  for less, greater in pairs { LEQUAL = "GREATER", LESS = "GEQUAL", EQUAL = "NOTEQUAL", ALWAYS = "NEVER" } do
    local a, b = compared(less), compared(greater)
    local lit = 0
    for y = 0, visibility.size - 1 do
      for x = 0, visibility.size - 1 do
        local here, there = a:color(x, y), b:color(x, y)
        -- A side that is turned from the light is dark whatever the map says, and so is its opposite;
        -- what is drawn by neither is the background, the same in both.
        if here ~= there then
          expect_equal(here + there, 255, less .. " at " .. x .. ", " .. y)
          lit = lit + 1
        end
      end
    end
    expect(lit > 1000, less)
  end
end)

test("lequal_is_less_or_equal", function()
  local least, less, equal = compared "LEQUAL", compared "LESS", compared "EQUAL"
  for y = 0, visibility.size - 1 do
    for x = 0, visibility.size - 1 do
      expect_equal(least:color(x, y), math.max((less:color(x, y)), (equal:color(x, y))), x .. ", " .. y)
    end
  end
end)

test("each_defect_is_wrong_in_more_pixels_than_the_map_without", function()
  local right = visibility.wrong("shadow_map_problems", "table")
  for _, defect in ipairs { "acne", "peter_panning", "aliasing", "too_small", "too_loose", "near_too_near" } do
    local wrong = visibility.wrong("shadow_map_problems", "table", { defect = defect })
    expect(wrong > right, defect .. ": " .. wrong .. ", without " .. right)
  end
end)

test("a_filter_leaves_alone_what_is_all_lit_or_all_dark", function()
  local hard_edge = visibility.render("shadow_map_pcf", "tetra", { number = 1, hardware = false })
  for _, pattern in ipairs { "grid", "poisson", "rotated" } do
    for _, weights in ipairs { "equal", "tent" } do
      local soft = visibility.render("shadow_map_pcf", "tetra", { pattern = pattern, weights = weights })
      local gray, differing = 0, 0
      for y = 0, visibility.size - 1 do
        for x = 0, visibility.size - 1 do
          local value = soft:color(x, y)
          local background = soft:color(x, y) == 217       -- 0.85
          if not background and value > 0 and value < 255 then gray = gray + 1
          elseif value ~= hard_edge:color(x, y) then differing = differing + 1 end
        end
      end
      expect(gray > 20, "no soft edge")
      -- Where the filter says all or nothing, so does the map: but for edges nearer than half a texel.
      expect(differing <= 10, pattern .. ", " .. weights .. ": " .. differing)
    end
  end
end)

-- A box filter over a straight edge is a ramp as wide as the filter, whose grey pixels are in proportion.
test("the_soft_edge_is_as_wide_as_the_filter", function()
  local function gray(width)
    local p = visibility.render("shadow_map_pcf", "tetra", { number = 8, width = width, size = 256 })
    local sum = 0
    for y = 0, visibility.size - 1 do
      for x = 0, visibility.size - 1 do
        local value = p:color(x, y)
        if value > 0 and value < 255 and value ~= 217 then sum = sum + 1 end
      end
    end
    return sum
  end
  expect_near(gray(16) / gray(8), 2, 0.5, "pixels are counted whole, on both sides of a band of some pixels")
end)

test("a_still_light_draws_its_map_once", function()
  local size = { 64, 64 }
  local first = render("shadow_map_fbo", { size = size, set = { keep = true } })
  local third = render("shadow_map_fbo", { size = size, frames = 3, set = { keep = true } })
  local redrawn = render("shadow_map_fbo", { size = size, frames = 3 })
  expect_equal(#first.passes, 2)
  expect_equal(#third.passes, 1)
  expect_equal(#redrawn.passes, 2)
  expect_equal(first:difference(third).differing, 0)
end)

test("a_kept_map_is_drawn_again_where_the_light_or_a_caster_moves", function()
  local still = require "parts.still"
  local function at(x) return { model = mat4.translate(x, 0, 0) } end
  local last, matrix = {}, mat4.scale(2, 2, 2)
  expect(not still(last, matrix, { at(1), at(2) }), "the first frame has no map")
  expect(still(last, matrix, { at(1), at(2) }), "nothing has moved")
  expect(not still(last, matrix, { at(1), at(2.5) }), "a caster has")
  expect(still(last, matrix, { at(1), at(2.5) }), "and stays")
  expect(not still(last, mat4.scale(3, 3, 3), { at(1), at(2.5) }), "the light has")
  expect(not still(last, mat4.scale(3, 3, 3), { at(1) }), "a caster is gone")
  expect(not still(last, mat4.scale(3, 3, 3), { at(1), at(2) }), "another has come")
end)
