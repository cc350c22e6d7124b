-- Which edges throw a quad: the lecture's three stages, left to right. Above, the picture, darkened by
-- a full-screen quad where the stencil is not zero; below, the stencil itself.
--   all         each face's edges: faces turned away count -1 and cancel the lit ones: cones of light
--   lit         each lit face's edges: right where counts are exact, but every inner edge is drawn
--               twice to cancel itself, and where a counter saturates (INCR, DECR) holes are left
--   silhouette  edges between a lit face and one that is not
local recipe = {
  title   = "Shadow volumes: which edges",
  lecture = "004_502e9deeb91da7bb: Où en est-on ? Des p'tits trous...",
  scene   = "tetra",
  params  = {
    light    = param.point(2, 4, 1),
    darkness = param.number(0.6, 0, 1),
    counting = param.choice("saturating", "wrapping"),
  },
}

local stages = { "all", "lit", "silhouette" }

function recipe.setup(r)
  r.phong = shader.load "phong"
  r.flat = shader.load "flat"
  r.volume = shader.load "volume"
  r.quad = mesh.quad()
end

-- One colour for each count, as quads where the stencil equals it.
local function show_stencil(r)
  local colors = { [0] = vec3(0.08), vec3(0.25, 0.45, 0.95), vec3(0.25, 0.8, 0.4), vec3(0.95, 0.75, 0.2),
                   vec3(0.95, 0.4, 0.25), vec3(0.85, 0.3, 0.8) }
  gl.StencilOp(gl.KEEP, gl.KEEP, gl.KEEP)
  gl.Disable(gl.DEPTH_TEST)
  gl.StencilFunc(gl.ALWAYS, 0, 0xFF)
  r.quad:draw(r.flat, { color = vec3(1), alpha = 1 })
  for count, color in pairs(colors) do
    gl.StencilFunc(gl.EQUAL, count, 0xFF)
    r.quad:draw(r.flat, { color = color, alpha = 1 })
  end
  gl.Enable(gl.DEPTH_TEST)
end

function recipe.draw(r)
  local scene, light, camera = r.scene, r.params.light, r.scene.camera
  local width, height = r.width // 3, r.height // 2
  local view = camera:view()
  local projection = shadow.infinite_perspective(camera.fovy, width / height, camera.near)
  local seen = { view = view, projection = projection, light = light }
  local up, down = gl.INCR, gl.DECR
  if r.params.counting == "wrapping" then up, down = gl.INCR_WRAP, gl.DECR_WRAP end

  gl.ClearColor(0.85, 0.88, 0.92, 1)
  gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT)
  gl.Enable(gl.DEPTH_TEST)
  gl.Enable(gl.SCISSOR_TEST)

  for i, edges in ipairs(stages) do
    -- The counts are made twice, once for the picture and once for the stencil below it.
    for row = 1, 0, -1 do
      gl.Viewport((i - 1) * width, row * height, width, height)
      gl.Scissor((i - 1) * width, row * height, width, height)
      local what = row == 1 and "" or ", the stencil"

      pass(edges .. what .. ": the scene, then its volumes", function()
        scene:draw(r.phong, seen)
        gl.ColorMask(false, false, false, false)
        gl.DepthMask(false)
        gl.Enable(gl.STENCIL_TEST)
        gl.StencilFunc(gl.ALWAYS, 0, 0xFF)
        gl.Enable(gl.CULL_FACE)
        for _, caster in ipairs(scene.casters) do
          local volume = shadow.volume(caster, nil, light, { edges = edges, caps = false })
          gl.CullFace(gl.BACK)
          gl.StencilOp(gl.KEEP, gl.KEEP, up)
          volume:draw_sides(r.volume, seen)
          gl.CullFace(gl.FRONT)
          gl.StencilOp(gl.KEEP, gl.KEEP, down)
          volume:draw_sides(r.volume, seen)
        end
        gl.Disable(gl.CULL_FACE)
        gl.ColorMask(true, true, true, true)
      end)

      pass(edges .. what .. (row == 1 and ": a dark quad over all" or " as colours"), function()
        if row == 1 then
          gl.Enable(gl.BLEND)
          gl.BlendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA)
          gl.StencilFunc(gl.NOTEQUAL, 0, 0xFF)
          gl.StencilOp(gl.KEEP, gl.KEEP, gl.KEEP)
          gl.Disable(gl.DEPTH_TEST)
          r.quad:draw(r.flat, { color = vec3(0), alpha = r.params.darkness })
          gl.Enable(gl.DEPTH_TEST)
          gl.Disable(gl.BLEND)
        else
          show_stencil(r)
        end
        gl.Disable(gl.STENCIL_TEST)
        gl.DepthMask(true)
      end)
    end
  end
end

return recipe
