-- Carmack's reverse: the volume's faces are counted where the depth test fails, behind what is seen.
-- The camera may then stand in the shadow, and the near plane may cut the volume; in return the
-- volume needs caps, and a far plane at infinity for the caps that lie there.
local batches_of = require "parts.batches"
local own_shadow = require "parts.own_shadow"
local scene_depth = require "parts.scene_depth"

local recipe = {
  title   = "Shadow volumes, z-fail",
  lecture = "004_502e9deeb91da7bb: Carmack's reverse",
  scene   = "table",
  truth   = "hard",
  params  = { light = param.point(2, 4, 1), darkness = param.number(0.25, 0, 1) },
}

recipe.limit = scene_depth.limit

function recipe.setup(r)
  r.phong = shader.load "phong"
  r.volume = shader.load "volume"
  r.flat = shader.load "flat"
  r.quad = mesh.quad()
end

function recipe.draw(r)
  local scene, light, camera = r.scene, r.params.light, r.scene.camera
  local view = camera:view()
  local projection = shadow.infinite_perspective(camera.fovy, r.width / r.height, camera.near)
  local seen = { view = view, projection = projection, light = light }
  local batches = batches_of(scene.casters, light)
  local objects, volumes, fronts = scene.objects, {}, nil

  gl.ClearColor(0.85, 0.88, 0.92, 1)
  gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT)
  gl.Enable(gl.DEPTH_TEST)

  pass("1. the scene in the depth buffer", function()
    gl.ColorMask(false, false, false, false)
    fronts = scene_depth.draw(objects, r.phong, seen)
  end)

  gl.DepthMask(false)
  pass("2. sides turned from the light are in their own shadow", function()
    for _, batch in ipairs(batches) do
      for _, drawn in ipairs(batch) do
        drawn.volume = shadow.volume(drawn.caster, nil, light, { part = drawn.part })
        table.insert(volumes, drawn.volume)
      end
    end
    own_shadow(volumes, r.volume, seen)
  end)

  for i, batch in ipairs(batches) do
    local group = #batches > 1 and (", group " .. i) or ""

    -- Both at once by StencilOpSeparate. Two draws with CullFace are the lecture's; but a sliver that
    -- a rasteriser's rounding turns round may be culled from both, and then one count is missing.
    pass("3. hidden back faces of the volumes +1, hidden front faces -1" .. group, function()
      gl.StencilFunc(gl.ALWAYS, 0, 0)
      -- INCR would stay at the highest value and lose count: INCR_WRAP does not.
      gl.StencilOpSeparate(gl.BACK, gl.KEEP, gl.INCR_WRAP, gl.KEEP)
      gl.StencilOpSeparate(gl.FRONT, gl.KEEP, gl.DECR_WRAP, gl.KEEP)
      for _, drawn in ipairs(batch) do drawn.volume:draw(r.volume, seen) end
    end)

    -- Bit 7 keeps what a group found, so that the next counts from zero: with one group there is
    -- nothing to keep.
    if #batches > 1 then
      pass("what is not zero becomes bit 7" .. group, function()
        gl.StencilMask(0xFF)
        gl.StencilFunc(gl.NOTEQUAL, 0x80, 0x7F)
        gl.StencilOp(gl.KEEP, gl.KEEP, gl.REPLACE)
        gl.Disable(gl.DEPTH_TEST)
        r.quad:draw(r.flat)
        gl.Enable(gl.DEPTH_TEST)
        gl.StencilMask(0x7F)
      end)
    end
  end

  gl.ColorMask(true, true, true, true)
  gl.StencilOp(gl.KEEP, gl.KEEP, gl.KEEP)
  scene_depth.match()

  -- NOTEQUAL 0: the slide's EQUAL 1 leaves what two casters shadow without either colour.
  pass("4. the dark part of the scene", function()
    gl.StencilFunc(gl.NOTEQUAL, 0, 0xFF)
    scene_depth.draw_again(objects, fronts, r.phong, {
      view = view, projection = projection, light = light, lit = 0, ambient = r.params.darkness })
  end)

  pass("5. the lit part of the scene", function()
    gl.StencilFunc(gl.EQUAL, 0, 0xFF)
    scene_depth.draw_again(objects, fronts, r.phong, {
      view = view, projection = projection, light = light, lit = 1, ambient = 0.25 })
  end)
end

return recipe
