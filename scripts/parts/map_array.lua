-- Depth maps in the layers of one array texture, and a framebuffer for each.
local map_array = {}

-- The texture, and its framebuffers: one for each layer.
function map_array.make(size, count)
  local maps = gl.GenTextures(1)
  gl.BindTexture(gl.TEXTURE_2D_ARRAY, maps)
  gl.TexImage3D(gl.TEXTURE_2D_ARRAY, 0, gl.DEPTH_COMPONENT24, size, size, count, 0,
                gl.DEPTH_COMPONENT, gl.FLOAT, nil)
  gl.TexParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_MIN_FILTER, gl.NEAREST)
  gl.TexParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_MAG_FILTER, gl.NEAREST)
  gl.TexParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_BORDER)
  gl.TexParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_BORDER)
  gl.TexParameterfv(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_BORDER_COLOR, { 1, 1, 1, 1 })
  gl.TexParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_COMPARE_MODE, gl.COMPARE_REF_TO_TEXTURE)
  gl.TexParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_COMPARE_FUNC, gl.LEQUAL)
  local frames = { gl.GenFramebuffers(count) }
  for i, frame in ipairs(frames) do
    gl.BindFramebuffer(gl.FRAMEBUFFER, frame)
    gl.FramebufferTextureLayer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, maps, 0, i - 1)
    gl.DrawBuffer(gl.NONE)
    gl.ReadBuffer(gl.NONE)
  end
  gl.BindFramebuffer(gl.FRAMEBUFFER, 0)
  return maps, frames
end

-- Of each of the maps, which layer it is, from 0; -1 where nobody reads it, and it has none. r.layers and
-- r.frames are made for as many as are read, and made anew where that are more than before.
function map_array.layers_of(r, size, maps)
  local layers, read = {}, 0
  for i, map in ipairs(maps) do
    layers[i] = map.read == false and -1 or read
    if map.read ~= false then read = read + 1 end
  end
  if read > #r.frames then
    if r.layers then
      gl.DeleteTextures(1, r.layers)
      gl.DeleteFramebuffers(#r.frames, table.unpack(r.frames))
    end
    r.layers, r.frames = map_array.make(size, read)
  end
  return layers
end

return map_array
