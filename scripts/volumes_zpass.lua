-- The six steps of the lecture: what is seen is in shadow where the eye's ray has entered more volumes
-- than it has left. Counted from the near plane on, so it is right only while no part of the near
-- plane is in shadow itself, and no more volumes than 7 bits count hold a point: `holds` says whether,
-- and the recipe prints it when it is not. A side so thin that rounding turns it round may be culled from both
-- draws, or from none, and then a pixel of it is a streak: volumes_two_sided has one draw for both.
local batches_of = require "parts.batches"
local own_shadow = require "parts.own_shadow"
local scene_depth = require "parts.scene_depth"

local recipe = {
  title   = "Shadow volumes, z-pass",
  lecture = "000_178f3ee06912f876: Volums d'ombra; 004_502e9deeb91da7bb: Stencil shadows",
  scene   = "table",
  truth   = "hard",
  params  = { light = param.point(2, 4, 1), darkness = param.number(0.25, 0, 1) },
}

recipe.limit = scene_depth.limit

function recipe.setup(r)
  r.phong = shader.load "phong"
  r.volume = shader.load "volume"
end

function recipe.holds(r)
  for _, caster in ipairs(r.scene.casters) do
    if shadow.needs_zfail(r.scene.camera, r.params.light, caster) then
      return false, "a caster may shadow the near plane from here, and all counts are off by that"
    end
  end
  if #batches_of(r.scene.casters, r.params.light) > 1 then
    return false, "more volumes may hold a point than 7 bits of the stencil count"
  end
  return true
end

function recipe.draw(r)
  local scene, light, camera = r.scene, r.params.light, r.scene.camera
  local view = camera:view()
  local projection = shadow.infinite_perspective(camera.fovy, r.width / r.height, camera.near)
  local seen = { view = view, projection = projection, light = light }
  local volumes = {}
  for k, caster in ipairs(scene.casters) do
    volumes[k] = shadow.volume(caster, nil, light, { caps = false })
  end
  local holds, why = recipe.holds(r)
  if not holds then print("z-pass: " .. why .. "; volumes_zfail is right") end

  gl.ClearColor(0.85, 0.88, 0.92, 1)
  gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT)
  gl.Enable(gl.DEPTH_TEST)

  pass("1. the scene in the depth buffer", function()
    gl.ColorMask(false, false, false, false)
    scene_depth.draw(scene.objects, r.phong, seen)
  end)

  gl.DepthMask(false)

  pass("sides turned from the light are in their own shadow", function()
    own_shadow(volumes, r.volume, seen)
  end)

  pass("2. front faces of the volumes: +1", function()
    gl.StencilFunc(gl.ALWAYS, 0, 0)
    gl.Enable(gl.CULL_FACE)
    gl.CullFace(gl.BACK)
    -- The slide's INCR stays at the highest value and DECR at 0, so that counts are lost on the way.
    gl.StencilOp(gl.KEEP, gl.KEEP, gl.INCR_WRAP)
    for _, volume in ipairs(volumes) do volume:draw_sides(r.volume, seen) end
  end)

  pass("3. back faces: -1", function()
    gl.CullFace(gl.FRONT)
    gl.StencilOp(gl.KEEP, gl.KEEP, gl.DECR_WRAP)
    for _, volume in ipairs(volumes) do volume:draw_sides(r.volume, seen) end
    gl.Disable(gl.CULL_FACE)
  end)

  gl.ColorMask(true, true, true, true)
  gl.StencilOp(gl.KEEP, gl.KEEP, gl.KEEP)
  scene_depth.match()

  -- NOTEQUAL 0: the slide's EQUAL 1 leaves out what two casters shadow.
  pass("4. the dark part of the scene", function()
    gl.StencilFunc(gl.NOTEQUAL, 0, 0xFF)
    scene:draw(r.phong, { view = view, projection = projection, light = light, lit = 0, ambient = r.params.darkness })
  end)

  pass("5. the lit part of the scene", function()
    gl.StencilFunc(gl.EQUAL, 0, 0xFF)
    scene:draw(r.phong, { view = view, projection = projection, light = light, lit = 1, ambient = 0.25 })
  end)

  pass("6. the initial state again", function()
    gl.Disable(gl.POLYGON_OFFSET_FILL)
    gl.DepthFunc(gl.LESS)
    gl.DepthMask(true)
    gl.Disable(gl.STENCIL_TEST)
  end)
end

return recipe
