local r = {}
function r.draw()
  local t = gl.GenTextures(1) gl.BindTexture(gl.TEXTURE_2D, t)
  gl.TexImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, 4, 4, 0, gl.RGBA, gl.UNSIGNED_BYTE, nil)
  gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST)
  local f = gl.GenFramebuffers(1) gl.BindFramebuffer(gl.FRAMEBUFFER, f)
  gl.FramebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, t, 0)
  gl.Viewport(0, 0, 4, 4) gl.Clear(gl.COLOR_BUFFER_BIT) gl.BindFramebuffer(gl.FRAMEBUFFER, 0)
  local b = gl.GenBuffers(1) gl.BindBuffer(gl.ARRAY_BUFFER, b) gl.BufferData(gl.ARRAY_BUFFER, 12, { 0, 1, 2 }, gl.STATIC_DRAW)
  gl.DeleteTextures(1, t) gl.DeleteBuffers(1, b) gl.DeleteFramebuffers(1, f)
  local m = mesh.new { positions = { vec3(0, 0, 0), vec3(1, 0, 0), vec3(0, 1, 0) }, indices = { 0, 1, 2 } }
  local v = shadow.volume(mesh.box(1, 1, 1), mat4.translate(1, 2, 3), vec4(1, 2, 3, 1), { edges = "silhouette", caps = true })
  print(m, v, vec3(1, 2, 3):cross(vec3(0, 1, 0)), quat.axis_angle(30, vec3(0, 1, 0)), gl.GetError())
end
return r
