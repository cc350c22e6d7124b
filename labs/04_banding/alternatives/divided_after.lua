-- Right in another way: floats do not overflow, so the sum may be divided at the end, by MULT.
local recipe = {
  title   = "Lab 04: an average without bands",
  lecture = "002_b957b372f85420d1: Banding in a limited buffer",
  params  = {
    times = param.integer(16, 1, 256),     -- drawings
    color = param.color(1, 0, 0),
    tilt  = param.number(180, 0, 360),     -- degrees; 180: bright at the left
  },
}

function recipe.setup(r)
  r.quad = mesh.quad()
  r.ramp = shader.compile{
    vertex = [[
      #version 330 core
      layout(location = 0) in vec3 position;
      void main() { gl_Position = vec4(position, 1.0); }
    ]],
    fragment = [[
      #version 330 core
      uniform vec2 size, along;
      uniform vec3 color;
      uniform float brightness;
      out vec4 fragment;
      void main() {
        float level = clamp(dot(gl_FragCoord.xy / size - 0.5, along) + 0.5, 0.0, 1.0);
        fragment = vec4(color * brightness * level, 1.0);
      }
    ]],
  }
end

-- The i-th of the drawings: the first at full brightness, the last at about half of it.
local function draw_ramp(r, i)
  local angle = math.rad(r.params.tilt)
  r.quad:draw(r.ramp, { size = vec2(r.width, r.height), along = vec2(math.cos(angle), math.sin(angle)),
                        color = r.params.color, brightness = 1 - 0.5 * (i - 1) / r.params.times })
end

function recipe.draw(r)
  local times = r.params.times

  pass("1. the drawings, accumulated", function()
    fbo.accumulation "float32"
    gl.Clear(gl.ACCUM_BUFFER_BIT)
    for i = 1, times do
      draw_ramp(r, i)
      gl.Accum(gl.ACCUM, 1)
    end
  end)

  pass("2. the average", function()
    gl.Accum(gl.MULT, 1 / times)
    gl.Accum(gl.RETURN, 1)
  end)
end

return recipe
