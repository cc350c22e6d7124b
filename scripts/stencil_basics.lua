-- The stencil buffer's two uses: one quad writes it, the next is drawn where it is 0. The last pass
-- writes the stencil's values over the picture, by nothing but the stencil test.
local recipe = {
  title   = "The stencil buffer",
  lecture = "000_178f3ee06912f876: Stencil buffer",
  params  = { numbers = param.toggle(true) },
  keys    = { n = "toggle numbers" },
}

function recipe.setup(r)
  r.flat = shader.load "flat"
  r.number = shader.load "number"
  r.quad = mesh.quad()
end

-- Corners in [-1, 1]², over the whole picture.
local function draw_quad(r, left, bottom, right, top, color)
  local model = mat4.translate((left + right) / 2, (bottom + top) / 2, 0)
              * mat4.scale((right - left) / 2, (top - bottom) / 2, 1)
  r.quad:draw(r.flat, { model = model, color = color })
end

function recipe.draw(r)
  gl.ClearColor(0.93, 0.93, 0.90, 1)
  gl.ClearStencil(0)
  gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT)

  pass("1. a quad writes 1 wherever it is drawn", function()
    gl.Enable(gl.STENCIL_TEST)
    gl.StencilFunc(gl.ALWAYS, 1, 255)
    gl.StencilOp(gl.KEEP, gl.KEEP, gl.REPLACE)
    draw_quad(r, -0.75, -0.75, 0.25, 0.25, vec3(0.36, 0.56, 0.84))
  end)

  pass("2. the next is drawn where the stencil is 0", function()
    gl.StencilFunc(gl.EQUAL, 0, 255)
    gl.StencilOp(gl.KEEP, gl.KEEP, gl.KEEP)
    draw_quad(r, -0.25, -0.25, 0.75, 0.75, vec3(0.94, 0.66, 0.32))
  end)

  pass("3. the stencil's values, as numbers", function()
    if not r.params.numbers then return end
    for value = 0, 1 do
      gl.StencilFunc(gl.EQUAL, value, 255)
      r.quad:draw(r.number, { value = value, cell = math.max(8, r.width // 16),
                              dot_size = math.max(1, r.width // 128),
                              color = value == 0 and vec3(0.45, 0.45, 0.42) or vec3(1) })
    end
  end)
end

return recipe
