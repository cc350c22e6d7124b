-- What each storage of the accumulation buffer makes of a ramp, exactly.
local function ramp(storage, times, average)
  return render("banding", { size = { 256, 2 },
                             set = { storage = storage, times = times, average = average or "during" } })
end

-- Calls visit(level, got) for the levels 0 to 255 of the ramp.
local function each_level(picture, visit)
  for level = 0, 255 do visit(level, (picture:color(255 - level, 1))) end
end

local function rounded(value) return math.floor(math.min(math.max(value, 0), 1) * 255 + 0.5) end

-- The whole number that `bits` of two's complement keep of a sum.
local function wrapped(sum, bits)
  local half = 1 << (bits - 1)
  return (sum + half) % (2 * half) - half
end

-- An integer storage of this many bits keeps steps of 1/one and drops what is below, each time.
-- In whole numbers: level/255 · one/times, truncated.
local function averaged_during(level, times, bits)
  local one = (1 << (bits - 1)) - 1
  return rounded(wrapped(times * (level * one // (255 * times)), bits) / one)
end

local function averaged_after(level, times, bits)
  local one = (1 << (bits - 1)) - 1
  return rounded(wrapped(times * (level * one // 255), bits) / one / times)
end

-- Powers of two: their inverses are exact, so what is held is the storage, not the weight's rounding.
local function each_times(visit)
  for power = 0, 10 do visit(1 << power) end
end

-- Of 127 steps a drawing leaves 127 level/2040, of which the fraction is dropped: 0 to 15.
test("eight_times_in_8_bits_are_16_bands", function()
  local bands = {}
  each_level(ramp("snorm8", 8), function(level, got)
    expect_equal(got, rounded(127 * level // 2040 * 8 / 127), "level " .. level)
    if bands[#bands] ~= got then bands[#bands + 1] = got end
    if level > 240 then expect_equal(got, 241, "level " .. level) end
  end)
  expect_equal(#bands, 16)
  naive("8 times in 8 bits are 16 bands", ramp("snorm8", 8))
end)

test("integers_drop_what_is_below_their_step_each_time", function()
  each_times(function(times)
    for storage, bits in pairs{ snorm8 = 8, snorm16 = 16 } do
      each_level(ramp(storage, times), function(level, got)
        expect_equal(got, averaged_during(level, times, bits),
                     storage .. ", " .. times .. " times, level " .. level)
      end)
    end
  end)
end)

test("integers_wrap_around_when_averaged_after", function()
  each_times(function(times)
    for storage, bits in pairs{ snorm8 = 8, snorm16 = 16 } do
      each_level(ramp(storage, times, "after"), function(level, got)
        expect_equal(got, averaged_after(level, times, bits),
                     storage .. ", " .. times .. " times, level " .. level)
      end)
    end
  end)
end)

test("white_in_16_bits_becomes_253_at_256_times_and_247_at_1024", function()
  expect_equal(ramp("snorm16", 8):color(0, 0), 255)
  expect_equal(ramp("snorm16", 256):color(0, 0), 253)
  expect_equal(ramp("snorm16", 1024):color(0, 0), 247)
  naive("in 16 bits white becomes 253 at 256 times and 247 at 1024", ramp("snorm16", 1024))
end)

test("averaging_after_makes_white_black", function()
  expect_equal(ramp("snorm16", 2, "after"):color(0, 0), 0)
end)

-- A sum of 1024 roundings to 24 bits is off by less than 1024/2^24 of a white of 255: a 60th of a step.
test("float32_gives_the_ramp_back_whatever_the_times", function()
  each_times(function(times)
    for _, average in ipairs{ "during", "after" } do
      each_level(ramp("float32", times, average), function(level, got)
        expect_equal(got, level, times .. " times, averaged " .. average)
      end)
    end
  end)
  ours("float32 gives the ramp back at 1 to 1024 times", ramp("float32", 1024))
end)

-- A number of 11 bits: the nearest, ties to even, or the next toward zero. Which of the two, OpenGL 4.5,
-- section 2.3.4.1, leaves to the driver. 2^-24 is the step of the least ones.
local function half(value, nearest)
  if value == 0 then return 0 end
  local step = math.max(2.0 ^ (math.floor(math.log(value, 2)) - 10), 2.0 ^ -24)
  local low = value // step
  local rest = value / step - low
  if nearest and (rest > 0.5 or (rest == 0.5 and low % 2 == 1)) then low = low + 1 end
  return low * step
end

test("float16_rounds_each_sum_to_11_bits", function()
  local off = { nearest = 0, toward_zero = 0 }
  each_times(function(times)
    each_level(ramp("float16", times), function(level, got)
      for way in pairs(off) do
        local sum = 0
        for _ = 1, times do sum = half(sum + level / 255 / times, way == "nearest") end
        if got ~= rounded(sum) then off[way] = off[way] + 1 end
      end
    end)
  end)
  expect(off.nearest == 0 or off.toward_zero == 0,
         off.nearest .. " pixels off the nearest, " .. off.toward_zero .. " off the one toward zero")
end)

test("all_storages_are_drawn_one_above_the_other", function()
  local all = render("banding", { size = { 256, 8 } })
  for i, storage in ipairs{ "float32", "float16", "snorm16", "snorm8" } do
    local one = ramp(storage, 8)
    for x = 0, 255 do
      for y = 2 * i - 2, 2 * i - 1 do
        expect_equal(vec4(all:color(x, y)), vec4(one:color(x, 0)), storage .. ", " .. x)
      end
    end
  end
end)

row{ case = 24, title = "Accumulation at N = 1 … 1024 in each storage", expected = "the exact round-off; white stays white where the storage allows it",
     facts = { "white_in_16_bits_becomes_253_at_256_times_and_247_at_1024", "eight_times_in_8_bits_are_16_bands",
               "integers_drop_what_is_below_their_step_each_time", "integers_wrap_around_when_averaged_after",
               "averaging_after_makes_white_black", "float32_gives_the_ramp_back_whatever_the_times",
               "float16_rounds_each_sum_to_11_bits" } }
