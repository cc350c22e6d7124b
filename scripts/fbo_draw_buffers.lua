-- Several colour buffers at once. One quad is drawn by a shader with four outputs, and DrawBuffers
-- says which attachment each output reaches; the picture shows the attachments side by side, 0 to 3
-- from the left, in five rows from the top:
--
--   1. {3, 1, NONE, 0}: output 0 goes to attachment 3, 1 to 1, 2 nowhere, 3 to attachment 0.
--   2. One colour for all draw buffers, here attachments 0 and 2. That is what gl_FragColor means; an
--      `out` of one's own reaches the draw buffer of its location alone, however few there are.
--   3. Blending for draw buffer 1 alone: Enablei, BlendFunci, BlendEquationi.
--   4. The scissor test. The slide counts it among the switches of a draw buffer; the index of
--      SCISSOR_TEST is a viewport's (OpenGL 4.5, section 17.3.2), so index 0 cuts all attachments
--      alike, and index 1 none of them. What one buffer alone is to miss, ColorMaski keeps from it.
--   5. A depth buffer that two framebuffer objects of different sizes share: what can be drawn to is
--      the intersection of the sizes.
local recipe = {
  title   = "Outputs and draw buffers",
  lecture = "003_dcbdf1292070997a: Framebuffer objects, eligiendo el buffer para escribir",
}

local vertex = [[
#version 330 core
layout(location = 0) in vec3 position;
uniform float depth = 0.0;
void main() { gl_Position = vec4(position.xy, depth, 1.0); }
]]

local four_outputs = [[
#version 330 core
layout(location = 0) out vec4 first;
layout(location = 1) out vec4 second;
layout(location = 2) out vec4 third;
layout(location = 3) out vec4 fourth;
uniform float alpha = 1.0;
void main() {
  first = vec4(1.0, 0.0, 0.0, alpha);   // red
  second = vec4(0.0, 1.0, 0.0, alpha);  // green
  third = vec4(0.0, 0.0, 1.0, alpha);   // blue
  fourth = vec4(1.0, 1.0, 0.0, alpha);  // yellow
}
]]

-- A single colour, for all draw buffers: gl_FragColor, which GLSL 4.20 takes out of the core profile.
local one_output = [[
#version 330 core
void main() { gl_FragColor = vec4(1.0, 0.0, 1.0, 1.0); }
]]

local one_color = [[
#version 330 core
layout(location = 0) out vec4 first;
layout(location = 1) out vec4 second;
uniform vec3 color;
void main() { first = second = vec4(color, 1.0); }
]]

local background = { 0.2, 0.2, 0.2, 1 }
local ATTACHMENTS = { gl.COLOR_ATTACHMENT0, gl.COLOR_ATTACHMENT1,
                      gl.COLOR_ATTACHMENT2, gl.COLOR_ATTACHMENT3 }

local function texture(width, height)
  local name = gl.GenTextures(1)
  gl.BindTexture(gl.TEXTURE_2D, name)
  gl.TexImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, width, height, 0, gl.RGBA, gl.UNSIGNED_BYTE, nil)
  gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST)
  return name
end

function recipe.setup(r)
  r.four = shader.compile { vertex = vertex, fragment = four_outputs }
  r.one = shader.compile { vertex = vertex, fragment = one_output }
  r.plain = shader.compile { vertex = vertex, fragment = one_color }
  r.quad = mesh.quad()
  r.columns, r.rows = r.width // 4, r.height // 5

  -- Four attachments, textures and a renderbuffer alike.
  r.fbo = gl.GenFramebuffers(1)
  gl.BindFramebuffer(gl.DRAW_FRAMEBUFFER, r.fbo)
  r.colors = {}
  for i = 1, 3 do
    r.colors[i] = texture(r.columns, r.rows)
    gl.FramebufferTexture2D(gl.DRAW_FRAMEBUFFER, ATTACHMENTS[i], gl.TEXTURE_2D, r.colors[i], 0)
  end
  r.colors[4] = gl.GenRenderbuffers(1)
  gl.BindRenderbuffer(gl.RENDERBUFFER, r.colors[4])
  gl.RenderbufferStorage(gl.RENDERBUFFER, gl.RGBA8, r.columns, r.rows)
  gl.FramebufferRenderbuffer(gl.DRAW_FRAMEBUFFER, gl.COLOR_ATTACHMENT3, gl.RENDERBUFFER, r.colors[4])

  -- One depth buffer for two objects. The second has attachments of two sizes besides.
  r.depth = gl.GenRenderbuffers(1)
  gl.BindRenderbuffer(gl.RENDERBUFFER, r.depth)
  gl.RenderbufferStorage(gl.RENDERBUFFER, gl.DEPTH_COMPONENT24, r.columns, r.rows)
  r.large, r.small = texture(r.columns, r.rows), texture(r.columns // 2, r.rows // 2)
  r.whole, r.mixed = gl.GenFramebuffers(2)
  gl.BindFramebuffer(gl.DRAW_FRAMEBUFFER, r.whole)
  gl.FramebufferTexture2D(gl.DRAW_FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, r.colors[1], 0)
  gl.FramebufferRenderbuffer(gl.DRAW_FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, r.depth)
  gl.BindFramebuffer(gl.DRAW_FRAMEBUFFER, r.mixed)
  gl.FramebufferTexture2D(gl.DRAW_FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, r.large, 0)
  gl.FramebufferTexture2D(gl.DRAW_FRAMEBUFFER, gl.COLOR_ATTACHMENT1, gl.TEXTURE_2D, r.small, 0)
  gl.FramebufferRenderbuffer(gl.DRAW_FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, r.depth)

  for _, fbo in ipairs { r.fbo, r.whole, r.mixed } do
    gl.BindFramebuffer(gl.DRAW_FRAMEBUFFER, fbo)
    if gl.CheckFramebufferStatus(gl.DRAW_FRAMEBUFFER) ~= gl.FRAMEBUFFER_COMPLETE then
      error "a framebuffer is not complete"
    end
  end
  -- Each way not to be complete, in words.
  for _, case in ipairs(require "parts.completeness") do
    print(string.format("%-40s %s", case.status, case.words))
  end
end

-- All four attachments to the background: ClearBufferfv counts draw buffers, not attachments.
local function clear_attachments(r)
  gl.BindFramebuffer(gl.DRAW_FRAMEBUFFER, r.fbo)
  gl.Viewport(0, 0, r.columns, r.rows)
  gl.DrawBuffers(4, ATTACHMENTS)
  for buffer = 0, 3 do gl.ClearBufferfv(gl.COLOR, buffer, background) end
end

-- One attachment into a cell of the picture, counted from the lower left.
local function show(r, fbo, attachment, column, row, width, height)
  gl.BindFramebuffer(gl.READ_FRAMEBUFFER, fbo)
  gl.ReadBuffer(attachment)
  gl.BindFramebuffer(gl.DRAW_FRAMEBUFFER, 0)
  local x, y = column * r.columns, row * r.rows
  gl.BlitFramebuffer(0, 0, width, height, x, y, x + width, y + height,
                     gl.COLOR_BUFFER_BIT, gl.NEAREST)
end

local function show_four(r, row)
  for i = 1, 4 do show(r, r.fbo, ATTACHMENTS[i], i - 1, row, r.columns, r.rows) end
end

function recipe.draw(r)
  gl.ClearColor(1, 1, 1, 1)
  gl.Clear(gl.COLOR_BUFFER_BIT)

  pass("1. DrawBuffers {3, 1, NONE, 0}", function()
    clear_attachments(r)
    local links = { gl.COLOR_ATTACHMENT3, gl.COLOR_ATTACHMENT1, gl.NONE, gl.COLOR_ATTACHMENT0 }
    gl.DrawBuffers(4, links)
    r.quad:draw(r.four)
    show_four(r, 4)
  end)

  pass("2. one output to all: attachments 0 and 2", function()
    clear_attachments(r)
    gl.DrawBuffers(2, { gl.COLOR_ATTACHMENT0, gl.COLOR_ATTACHMENT2 })
    r.quad:draw(r.one)
    show_four(r, 3)
  end)

  pass("3. blending for draw buffer 1 alone", function()
    clear_attachments(r)
    gl.Enablei(gl.BLEND, 1)
    gl.BlendFunci(1, gl.SRC_ALPHA, gl.ONE)           -- background + 0.5 green
    gl.BlendEquationi(1, gl.FUNC_ADD)
    r.quad:draw(r.four, { alpha = 0.5 })
    gl.Disablei(gl.BLEND, 1)
    show_four(r, 2)
  end)

  pass("4. scissor 0 cuts them all, scissor 1 none; ColorMaski keeps one", function()
    clear_attachments(r)
    gl.Scissor(0, 0, r.columns // 2, r.rows)
    gl.Enablei(gl.SCISSOR_TEST, 0)
    r.quad:draw(r.four)                               -- the left half of all four
    gl.Disablei(gl.SCISSOR_TEST, 0)
    gl.Enablei(gl.SCISSOR_TEST, 1)                    -- viewport 1, which nothing is drawn to
    gl.ColorMaski(0, false, false, false, false)
    gl.ColorMaski(1, false, false, false, false)
    r.quad:draw(r.four)                               -- all of attachments 2 and 3
    gl.ColorMask(true, true, true, true)
    gl.Disablei(gl.SCISSOR_TEST, 1)
    show_four(r, 1)
  end)

  pass("5. a depth buffer shared by objects of different sizes", function()
    gl.BindFramebuffer(gl.DRAW_FRAMEBUFFER, r.whole)
    gl.Viewport(0, 0, r.columns, r.rows)
    gl.ClearColor(0.2, 0.2, 0.2, 1)
    gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
    gl.Enable(gl.DEPTH_TEST)
    gl.Scissor(0, 0, r.columns // 4, r.rows)
    gl.Enable(gl.SCISSOR_TEST)
    r.quad:draw(r.plain, { depth = -0.5, color = vec3(1, 0, 0) })   -- near, in the left quarter
    gl.Disable(gl.SCISSOR_TEST)
    show(r, r.whole, gl.COLOR_ATTACHMENT0, 0, 0, r.columns, r.rows)

    -- Green is behind red, wherever the depth buffer has it; and it reaches the small attachment's
    -- size, in the large one too.
    gl.BindFramebuffer(gl.DRAW_FRAMEBUFFER, r.mixed)
    gl.DrawBuffers(2, { gl.COLOR_ATTACHMENT0, gl.COLOR_ATTACHMENT1 })
    for buffer = 0, 1 do gl.ClearBufferfv(gl.COLOR, buffer, background) end
    r.quad:draw(r.plain, { depth = 0.5, color = vec3(0, 1, 0) })
    gl.Disable(gl.DEPTH_TEST)
    show(r, r.mixed, gl.COLOR_ATTACHMENT0, 1, 0, r.columns, r.rows)
    show(r, r.mixed, gl.COLOR_ATTACHMENT1, 2, 0, r.columns // 2, r.rows // 2)
  end)
end

return recipe
