-- A buffer of a size below zero.
-- expect: recipe error
return {
  draw = function(r)
    gl.BindBuffer(gl.ARRAY_BUFFER, gl.GenBuffers(1))
    gl.BufferData(gl.ARRAY_BUFFER, -1, nil, gl.STATIC_DRAW)
  end,
}
