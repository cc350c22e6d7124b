-- Several lights: light adds up, so each gets its own count, and adds its colours where that is 0.
-- What no light reaches keeps the first pass, the ambient part. A light's share is the same for all,
-- so that together they give what one gives.
local batches_of = require "parts.batches"
local own_shadow = require "parts.own_shadow"
local scene_depth = require "parts.scene_depth"

local recipe = {
  title   = "Shadow volumes, several lights",
  lecture = "004_502e9deeb91da7bb: Carmack's reverse, once for each light",
  scene   = "lamps",
  params  = {
    darkness = param.number(0.25, 0, 1),
    only     = param.integer(0, 0, 8),  -- 0: all lights; else that one alone
  },
}

function recipe.setup(r)
  r.phong = shader.load "phong"
  r.volume = shader.load "volume"
  r.flat = shader.load "flat"
  r.quad = mesh.quad()
end

-- Leaves in the stencil what is not 0 where `light` does not reach.
local function count_volumes(r, light, seen, name)
  local batches, volumes = batches_of(r.scene.casters, light), {}
  pass(name .. ": what is turned from it", function()
    gl.ColorMask(false, false, false, false)
    gl.DepthFunc(gl.LESS)
    gl.DepthMask(true)
    gl.StencilMask(0xFF)
    gl.Clear(gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT)
    scene_depth.draw(r.scene.objects, r.phong, seen)
    gl.DepthMask(false)
    for _, batch in ipairs(batches) do
      for _, drawn in ipairs(batch) do
        drawn.volume = shadow.volume(drawn.caster, nil, light, { part = drawn.part })
        table.insert(volumes, drawn.volume)
      end
    end
    own_shadow(volumes, r.volume, seen)
  end)

  for i, batch in ipairs(batches) do
    pass(name .. ": its volumes" .. (#batches > 1 and ", group " .. i or ""), function()
      gl.StencilFunc(gl.ALWAYS, 0, 0)
      gl.StencilOpSeparate(gl.BACK, gl.KEEP, gl.INCR_WRAP, gl.KEEP)
      gl.StencilOpSeparate(gl.FRONT, gl.KEEP, gl.DECR_WRAP, gl.KEEP)
      for _, drawn in ipairs(batch) do drawn.volume:draw(r.volume, seen) end
      if #batches > 1 then
        gl.StencilMask(0xFF)
        gl.StencilFunc(gl.NOTEQUAL, 0x80, 0x7F)
        gl.StencilOp(gl.KEEP, gl.KEEP, gl.REPLACE)
        gl.Disable(gl.DEPTH_TEST)
        r.quad:draw(r.flat)
        gl.Enable(gl.DEPTH_TEST)
        gl.StencilMask(0x7F)
      end
    end)
  end
end

function recipe.draw(r)
  local scene, camera, darkness = r.scene, r.scene.camera, r.params.darkness
  local view = camera:view()
  local projection = shadow.infinite_perspective(camera.fovy, r.width / r.height, camera.near)
  local lights = scene.lights

  gl.ClearColor(0.85, 0.88, 0.92, 1)
  gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
  gl.Enable(gl.DEPTH_TEST)

  pass("the ambient part", function()
    scene:draw(r.phong, { view = view, projection = projection, lit = 0, ambient = darkness })
  end)

  local share = (1 - darkness) / #lights
  gl.BlendColor(share, share, share, share)
  gl.BlendFunc(gl.CONSTANT_COLOR, gl.ONE)

  for i, light in ipairs(lights) do
    if r.params.only == 0 or r.params.only == i then
      local seen = { view = view, projection = projection, light = light }
      count_volumes(r, light, seen, "light " .. i)

      pass("light " .. i .. ": its colours where it reaches", function()
        gl.ColorMask(true, true, true, true)
        scene_depth.match()
        gl.StencilFunc(gl.EQUAL, 0, 0xFF)
        gl.StencilOp(gl.KEEP, gl.KEEP, gl.KEEP)
        gl.Enable(gl.BLEND)
        scene:draw(r.phong, { view = view, projection = projection, light = light, lit = 1, ambient = 0 })
        gl.Disable(gl.BLEND)
      end)
    end
  end
end

return recipe
