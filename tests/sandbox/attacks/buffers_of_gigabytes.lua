-- A buffer of 4 GiB.
-- expect: recipe error
return {
  draw = function(r)
    gl.BindBuffer(gl.ARRAY_BUFFER, gl.GenBuffers(1))
    gl.BufferData(gl.ARRAY_BUFFER, 1 << 32, nil, gl.STATIC_DRAW)
  end,
}
