-- Right in another way, the one that the lab allows where there is no accumulation buffer: each drawing
-- is copied into a texture and added to a framebuffer of floats, by blending.
local hard_room = require "parts.hard_room"

local recipe = {
  title   = "Lab 02: soft shadows by the accumulation buffer",
  lecture = "002_b957b372f85420d1: Soft shadows",
  scene   = "room",
  params  = {
    light      = param.point(0.2, 2.1, 0.9),
    numJitters = param.integer(8, 1, 256),
    radius     = param.number(0.25, 0, 1),    -- of the lamp, a sphere
    darkness   = param.number(0.25, 0, 1),
  },
}

function recipe.setup(r)
  hard_room.setup(r)
  r.quad = mesh.quad()
  r.weigh = shader.compile{
    vertex = [[
      #version 330 core
      layout(location = 0) in vec3 position;
      void main() { gl_Position = vec4(position, 1.0); }
    ]],
    fragment = [[
      #version 330 core
      uniform sampler2D drawing;
      uniform float weight;
      out vec4 fragment;
      void main() { fragment = weight * texelFetch(drawing, ivec2(gl_FragCoord.xy), 0); }
    ]],
  }
  r.sum_frame, r.sum = fbo.color(r.width, r.height, gl.RGBA32F)
  r.drawing = gl.GenTextures(1)
  gl.BindTexture(gl.TEXTURE_2D, r.drawing)
  gl.TexStorage2D(gl.TEXTURE_2D, 1, gl.RGBA8, r.width, r.height)
end

-- Draws `weight` times what is in `texture` over the whole of the bound framebuffer.
local function draw_weighed(r, texture, weight)
  gl.BindTexture(gl.TEXTURE_2D, texture)
  gl.Disable(gl.DEPTH_TEST)
  r.quad:draw(r.weigh, { drawing = 0, weight = weight })
end

function recipe.draw(r)
  local light, numJitters = r.params.light, r.params.numJitters
  -- numJitters places in the lamp, as offsets from its centre.
  local jitters = shadow.samples({ center = vec3(0), radius = r.params.radius }, numJitters, "hammersley", 1)

  gl.ClearColor(0.10, 0.11, 0.14, 1)
  gl.BindFramebuffer(gl.FRAMEBUFFER, r.sum_frame)
  gl.ClearBufferfv(gl.COLOR, 0, { 0, 0, 0, 0 })
  gl.BindFramebuffer(gl.FRAMEBUFFER, 0)

  for i = 1, numJitters do
    pass("drawing " .. i .. " of " .. numJitters, function()
      local jittered = light + vec4(jitters[i].xyz, 0)
      gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
      hard_room.draw(r, jittered, r.params.darkness)
      gl.BindTexture(gl.TEXTURE_2D, r.drawing)
      gl.CopyTexSubImage2D(gl.TEXTURE_2D, 0, 0, 0, 0, 0, r.width, r.height)
      gl.BindFramebuffer(gl.FRAMEBUFFER, r.sum_frame)
      gl.Enable(gl.BLEND)
      gl.BlendFunc(gl.ONE, gl.ONE)
      draw_weighed(r, r.drawing, 1 / numJitters)
      gl.Disable(gl.BLEND)
      gl.BindFramebuffer(gl.FRAMEBUFFER, 0)
    end)
  end

  pass("the average", function()
    draw_weighed(r, r.sum, 1)
  end)
end

return recipe
