local r = { scene = "tetra", truth = "hard", params = { light = param.point(2, 4, 1), n = param.integer(1, 0, 9),
  on = param.toggle(true), way = param.choice("a", "b"), tint = param.color(1, 0, 0) },
  keys = { s = "toggle n 0 1" }, sweep = { n = { 1, 4 } } }
function r.setup(r) r.flat = shader.load "flat"; r.map = fbo.depth(8, 8) end
function r.draw(r)
  local camera = r.scene.camera
  pass("1. one", function()
    gl.ClearColor(0, 0.5, 1, 1)
    gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT)
    gl.Enable(gl.STENCIL_TEST) gl.StencilFunc(gl.ALWAYS, 1, 0xFF) gl.StencilOp(gl.KEEP, gl.KEEP, gl.REPLACE)
    r.scene.receivers[1]:draw(r.flat, { view = camera:view(), projection = camera:projection(1), color = vec3(1, 0, 0) })
  end)
  pass("2. two", function()
    local plane = shadow.planar(r.scene.receivers[1].plane, r.params.light)
    gl.PolygonOffset(-1, 2) gl.BlendFunc(gl.ONE, gl.ZERO) gl.ColorMask(true, false, true, true)
    mesh.quad():draw(r.flat, { view = plane, projection = mat4.identity(), color = vec3(0) })
    gl.Accum(gl.LOAD, 0.5) gl.Accum(gl.RETURN, 2)
  end)
end
return r
