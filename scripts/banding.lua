-- What a limited accumulation buffer does to an average. The ramp 255, 254, … 1, 0 is drawn into it
-- many times, and the average is the ramp again, if the buffer can hold it.
--   during  each drawing is added with weight 1/times. An integer storage drops what is below its
--           step, each time: in 8 bits (127 steps from 0 to 1) the levels above 240 all become 241,
--           those above 224 become 225: 16 bands. In 16 bits nothing is seen of it at 8 times, but
--           at 1024 white becomes 247.
--   after   all are added with weight 1, and the sum is divided. Integers wrap around at ±1: what
--           overflows into the negative is clamped to black, or comes back as another level.
-- Floats do not wrap. Those of 16 bits still lose the last bits of a sum: at 1024 times it is dark.
local recipe = {
  title   = "Banding in a limited accumulation buffer",
  lecture = "002_b957b372f85420d1: Banding in a limited buffer",
  params  = {
    storage = param.choice("all", "snorm8", "snorm16", "float16", "float32"),  -- all: one above the other
    times   = param.integer(8, 1, 1024),
    average = param.choice("during", "after"),
  },
  keys    = { a = "next average", ["["] = "multiply times 0.5", ["]"] = "multiply times 2" },
  sweep   = { times = { 1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024 } },
}

function recipe.setup(r)
  r.ramp = shader.load "ramp"
  r.quad = mesh.quad()
end

-- The ramp, accumulated and brought back, within the scissor box.
local function average(r, storage)
  local times = r.params.times
  local during = r.params.average == "during"
  fbo.accumulation(storage)
  r.quad:draw(r.ramp, { width = r.width })
  gl.Clear(gl.ACCUM_BUFFER_BIT)
  -- The lecture draws the scene each time; it does not change, and GL keeps it.
  for _ = 1, times do gl.Accum(gl.ACCUM, during and 1 / times or 1) end
  gl.Accum(gl.RETURN, during and 1 or 1 / times)
end

function recipe.draw(r)
  local storages = { r.params.storage }
  if r.params.storage == "all" then storages = { "float32", "float16", "snorm16", "snorm8" } end

  gl.Enable(gl.SCISSOR_TEST)
  for i, storage in ipairs(storages) do
    pass(storage .. ", averaged " .. r.params.average, function()
      local low, high = (i - 1) * r.height // #storages, i * r.height // #storages
      gl.Scissor(0, low, r.width, high - low)
      average(r, storage)
    end)
  end
end

return recipe
