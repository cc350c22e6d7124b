-- Z-fail is always right and costs caps and hidden pixels; z-pass is right for every caster that does
-- not shadow the near plane. So each caster is counted by the one that it needs, into one stencil: both
-- leave there how many volumes hold the pixel.
local batches_of = require "parts.batches"
local own_shadow = require "parts.own_shadow"
local scene_depth = require "parts.scene_depth"

local recipe = {
  title   = "Shadow volumes, z-pass or z-fail for each caster",
  lecture = "004_502e9deeb91da7bb: Suivant les cas, on utilisera z-pass ou z-fail",
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
        drawn.zfail = shadow.needs_zfail(camera, light, drawn.caster)
        drawn.volume = shadow.volume(drawn.caster, nil, light, { caps = drawn.zfail, part = drawn.part })
        table.insert(volumes, drawn.volume)
      end
    end
    own_shadow(volumes, r.volume, seen)
  end)

  for i, batch in ipairs(batches) do
    local group = #batches > 1 and (", group " .. i) or ""

    pass("3. volumes by z-fail where the near plane may be in shadow, else by z-pass" .. group, function()
      gl.StencilFunc(gl.ALWAYS, 0, 0)
      for _, drawn in ipairs(batch) do
        if drawn.zfail then
          gl.StencilOpSeparate(gl.BACK, gl.KEEP, gl.INCR_WRAP, gl.KEEP)
          gl.StencilOpSeparate(gl.FRONT, gl.KEEP, gl.DECR_WRAP, gl.KEEP)
          drawn.volume:draw(r.volume, seen)
        else
          gl.StencilOpSeparate(gl.FRONT, gl.KEEP, gl.KEEP, gl.INCR_WRAP)
          gl.StencilOpSeparate(gl.BACK, gl.KEEP, gl.KEEP, gl.DECR_WRAP)
          drawn.volume:draw_sides(r.volume, seen)
        end
      end
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
