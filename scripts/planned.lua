-- Shadow volumes of what the frame needs, and no more: volumes_zfail with casters dropped whose volume
-- reaches nothing that is seen, or nothing but a box's own sides that are turned from the light, which
-- pass 2 marks without it; z-pass without caps where that is right, each volume inside the pixels where
-- it can count, and the dark part of only what a shadow may reach. Not a pixel differs.
-- `shadowlab run planned --explain` says what was kept and dropped, and why.
local batches_of = require "parts.batches"
local own_shadow = require "parts.own_shadow"
local scene_depth = require "parts.scene_depth"

local recipe = {
  title   = "Shadow volumes by plan",
  lecture = "004_502e9deeb91da7bb: Suivant les cas, on utilisera z-pass ou z-fail",
  scene   = "city",
  truth   = "hard",
  params  = {
    light    = param.direction(0.7, 0.75, 0.3),
    darkness = param.number(0.25, 0, 1),
    plan     = param.toggle(true),   -- false: the same passes of all of the scene
  },
}

recipe.limit = scene_depth.limit

function recipe.setup(r)
  r.phong = shader.load "phong"
  r.volume = shader.load "volume"
  r.flat = shader.load "flat"
  r.ambient = shader.load "ambient"
  r.quad = mesh.quad()
end

-- What a frame draws that has no plan, in a plan's form.
local function everything(r)
  local whole = { 0, 0, r.width, r.height }
  local objects = r.scene.objects
  local all = { casters = r.scene.casters, needs = {}, scissor = whole, seen = objects, shadowed = objects }
  for _, caster in ipairs(all.casters) do
    all.needs[caster] = { zfail = true, unlit = true, scissor = whole }
  end
  return all
end

function recipe.draw(r)
  local scene, light, camera = r.scene, r.params.light, r.scene.camera
  local view = camera:view()
  local projection = shadow.infinite_perspective(camera.fovy, r.width / r.height, camera.near)
  local seen = { view = view, projection = projection, light = light }
  local plan = r.params.plan and shadow.plan(scene, camera, light) or everything(r)
  local reaching, unlit = {}, {}   -- casters that shadow others; those that shadow themselves alone
  for _, caster in ipairs(plan.casters) do
    table.insert(plan.needs[caster].scissor and reaching or unlit, caster)
  end
  local batches = batches_of(reaching, light)
  local volumes, fronts = {}, nil

  gl.ClearColor(0.85, 0.88, 0.92, 1)
  gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT)
  gl.Enable(gl.DEPTH_TEST)

  pass("1. what is seen in the depth buffer", function()
    gl.ColorMask(false, false, false, false)
    fronts = scene_depth.draw(plan.seen, r.flat, seen)
  end)

  gl.DepthMask(false)
  pass("2. sides turned from the light are in their own shadow", function()
    for _, batch in ipairs(batches) do
      for _, drawn in ipairs(batch) do
        local needs = plan.needs[drawn.caster]
        drawn.volume = shadow.volume(drawn.caster, nil, light, { caps = needs.zfail, part = drawn.part })
        if needs.unlit then table.insert(volumes, drawn.volume) end
      end
    end
    for _, caster in ipairs(unlit) do
      table.insert(volumes, shadow.volume(caster, nil, light, { caps = false }))
    end
    own_shadow(volumes, r.volume, seen)
  end)

  for i, batch in ipairs(batches) do
    local group = #batches > 1 and (", group " .. i) or ""

    pass("3. each volume where it counts, by z-fail where it needs that, else by z-pass" .. group, function()
      gl.StencilFunc(gl.ALWAYS, 0, 0)
      gl.Enable(gl.SCISSOR_TEST)
      for _, drawn in ipairs(batch) do
        local needs = plan.needs[drawn.caster]
        gl.Scissor(table.unpack(needs.scissor))
        if needs.zfail then
          gl.StencilOpSeparate(gl.BACK, gl.KEEP, gl.INCR_WRAP, gl.KEEP)
          gl.StencilOpSeparate(gl.FRONT, gl.KEEP, gl.DECR_WRAP, gl.KEEP)
          drawn.volume:draw(r.volume, seen)
        else
          gl.StencilOpSeparate(gl.FRONT, gl.KEEP, gl.KEEP, gl.INCR_WRAP)
          gl.StencilOpSeparate(gl.BACK, gl.KEEP, gl.KEEP, gl.DECR_WRAP)
          drawn.volume:draw_sides(r.volume, seen)
        end
      end
      gl.Disable(gl.SCISSOR_TEST)
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

  pass("4. the dark part of what a shadow may reach", function()
    gl.StencilFunc(gl.NOTEQUAL, 0, 0xFF)
    gl.Enable(gl.SCISSOR_TEST)
    gl.Scissor(table.unpack(plan.scissor))
    scene_depth.draw_again(plan.shadowed, fronts, r.ambient, {
      view = view, projection = projection, ambient = r.params.darkness })
    gl.Disable(gl.SCISSOR_TEST)
  end)

  pass("5. the lit part of what is seen", function()
    gl.StencilFunc(gl.EQUAL, 0, 0xFF)
    scene_depth.draw_again(plan.seen, fronts, r.phong, {
      view = view, projection = projection, light = light, lit = 1, ambient = 0.25 })
  end)
end

return recipe
