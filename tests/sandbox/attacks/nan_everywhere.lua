-- NaN and infinities wherever a number goes.
-- expect: finished or recipe error
return {
  draw = function(r)
    local nan, inf = 0 / 0, 1 / 0
    for _, x in ipairs { nan, inf, -inf, 1e300, 5e-324 } do
      pcall(gl.ClearColor, x, x, x, x)
      pcall(gl.ClearDepth, x)
      pcall(gl.DepthRange, x, x)
      pcall(gl.PolygonOffset, x, x)
      pcall(gl.LineWidth, x)
      pcall(gl.PointSize, x)
      pcall(gl.Accum, gl.ACCUM, x)
      pcall(gl.VertexAttrib4f, 0, x, x, x, x)
      local v = vec4(x, x, x, x)
      pcall(shadow.planar, v, v)
      pcall(shadow.infinite_perspective, x, x, x)
      pcall(shadow.volume, mesh.box(1), mat4.translate(x, x, x), v, {})
      pcall(shadow.samples, { center = vec3(x, x, x), radius = x }, 4)
      pcall(mesh.sphere, x, 8, 8)
      pcall(function()
        mesh.box(1):draw(shader.load "phong", { view = mat4.translate(x, x, x), projection = mat4.perspective(x, x, x, x), light = v })
      end)
    end
    gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
  end,
}
