-- Each answer of CheckFramebufferStatus that a framebuffer object can be brought to, how, and what it
-- means (OpenGL 4.5, section 9.4.2). FRAMEBUFFER_UNDEFINED is left: it says that the window system
-- gave no framebuffer 0, and here the main frame always exists. FRAMEBUFFER_INCOMPLETE_DRAW_BUFFER and
-- _READ_BUFFER (a draw or read buffer names an attachment that is empty) are answers of GL 3; since 4.1
-- drawing to such a buffer is drawing to none, and the object is complete.
local function renderbuffer(format, samples)
  local name = gl.GenRenderbuffers(1)
  gl.BindRenderbuffer(gl.RENDERBUFFER, name)
  if samples then
    gl.RenderbufferStorageMultisample(gl.RENDERBUFFER, samples, format, 16, 16)
  elseif format then
    gl.RenderbufferStorage(gl.RENDERBUFFER, format, 16, 16)
  end
  return name
end

local function attach(attachment, name)
  gl.FramebufferRenderbuffer(gl.DRAW_FRAMEBUFFER, attachment, gl.RENDERBUFFER, name)
end

local cases = {
  { status = "FRAMEBUFFER_COMPLETE",
    words = "a colour buffer with storage: it can be drawn to",
    build = function() attach(gl.COLOR_ATTACHMENT0, renderbuffer(gl.RGBA8)) end },
  { status = "FRAMEBUFFER_COMPLETE",
    words = "a depth buffer alone, with the draw buffer NONE: a shadow map",
    build = function()
      attach(gl.DEPTH_ATTACHMENT, renderbuffer(gl.DEPTH_COMPONENT24))
      gl.DrawBuffer(gl.NONE)
    end },
  { status = "FRAMEBUFFER_COMPLETE",
    words = "a draw buffer without an attachment: what is drawn there is lost, but nothing is wrong",
    build = function()
      attach(gl.COLOR_ATTACHMENT0, renderbuffer(gl.RGBA8))
      gl.DrawBuffers(2, { gl.COLOR_ATTACHMENT0, gl.COLOR_ATTACHMENT1 })
    end },
  { status = "FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT",
    words = "nothing is attached, so there is nothing to draw to",
    build = function() end },
  { status = "FRAMEBUFFER_INCOMPLETE_ATTACHMENT",
    words = "the attached renderbuffer has no storage: RenderbufferStorage was not called",
    build = function() attach(gl.COLOR_ATTACHMENT0, renderbuffer()) end },
  { status = "FRAMEBUFFER_INCOMPLETE_ATTACHMENT",
    words = "a colour format is attached where depth belongs",
    build = function() attach(gl.DEPTH_ATTACHMENT, renderbuffer(gl.RGBA8)) end },
  { status = "FRAMEBUFFER_INCOMPLETE_MULTISAMPLE",
    words = "the attachments have different numbers of samples",
    build = function()
      attach(gl.COLOR_ATTACHMENT0, renderbuffer(gl.RGBA8))
      attach(gl.COLOR_ATTACHMENT1, renderbuffer(gl.RGBA8, 4))
    end },
  { status = "FRAMEBUFFER_INCOMPLETE_LAYER_TARGETS",
    words = "one attachment has layers (all faces of a cube map), another has none",
    build = function()
      local cube, flat = gl.GenTextures(2)
      gl.BindTexture(gl.TEXTURE_CUBE_MAP, cube)
      gl.TexStorage2D(gl.TEXTURE_CUBE_MAP, 1, gl.RGBA8, 16, 16)
      gl.BindTexture(gl.TEXTURE_2D, flat)
      gl.TexStorage2D(gl.TEXTURE_2D, 1, gl.RGBA8, 16, 16)
      gl.FramebufferTexture(gl.DRAW_FRAMEBUFFER, gl.COLOR_ATTACHMENT0, cube, 0)
      gl.FramebufferTexture(gl.DRAW_FRAMEBUFFER, gl.COLOR_ATTACHMENT1, flat, 0)
    end },
  { status = "FRAMEBUFFER_UNSUPPORTED",
    words = "nothing is wrong with any attachment, but this driver cannot draw to them together: here "
            .. "depth and stencil in buffers of their own; take one DEPTH24_STENCIL8 for both",
    build = function()
      attach(gl.DEPTH_ATTACHMENT, renderbuffer(gl.DEPTH_COMPONENT24))
      attach(gl.STENCIL_ATTACHMENT, renderbuffer(gl.STENCIL_INDEX8))
    end },
}

return cases
