-- Carmack's reverse with volumes that a shader makes: the casters' vertices never change, and when the
-- light moves nothing is computed or sent but the light itself.
--   vertex shader    each triangle has its caps and its sides at hand; vertices of w = 0 are pushed to
--                    infinity, and what does not belong to the volume is sent out of the view
--   geometry shader  each triangle knows its three neighbours and throws a side where one differs
local batches_of = require "parts.batches"
local own_shadow = require "parts.own_shadow"
local scene_depth = require "parts.scene_depth"

local recipe = {
  title   = "Shadow volumes, extruded by shaders",
  lecture = "004_502e9deeb91da7bb: L'utilisation des vertex shaders (et éventuellement des geometry shaders)",
  scene   = "table",
  truth   = "hard",
  params  = {
    light    = param.point(2, 4, 1),
    darkness = param.number(0.25, 0, 1),
    extruder = param.choice("vertex", "geometry"),
  },
}

recipe.limit = scene_depth.limit

function recipe.setup(r)
  r.phong = shader.load "phong"
  r.extrude = { vertex = shader.load "extrude_vertex", geometry = shader.load "extrude_geometry" }
  r.unlit = { vertex = shader.load "unlit_vertex", geometry = shader.load "unlit_geometry" }
  -- What a geometry shader emits may be rounded otherwise than what a vertex shader gives, as it is by
  -- Mesa, invariant or not. A cap must fail the depth test against the surface that it lies on; so that
  -- surface comes the same way.
  r.depth = { vertex = r.phong, geometry = shader.load "depth_geometry" }
  r.flat = shader.load "flat"
  r.quad = mesh.quad()
end

function recipe.draw(r)
  local scene, light, camera = r.scene, r.params.light, r.scene.camera
  local extruder = r.params.extruder
  local view = camera:view()
  local projection = shadow.infinite_perspective(camera.fovy, r.width / r.height, camera.near)
  local seen = { view = view, projection = projection, light = light }
  local batches = batches_of(scene.casters, light)
  local extrusions = {}

  gl.ClearColor(0.85, 0.88, 0.92, 1)
  gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT)
  gl.Enable(gl.DEPTH_TEST)

  pass("1. the scene in the depth buffer", function()
    gl.ColorMask(false, false, false, false)
    scene_depth.draw(scene.objects, r.depth[extruder], { view = view, projection = projection })
  end)

  gl.DepthMask(false)
  pass("2. sides turned from the light are in their own shadow", function()
    for _, batch in ipairs(batches) do
      for _, drawn in ipairs(batch) do
        drawn.extrusion = shadow.extrusion(drawn.caster, extruder, nil, { part = drawn.part, light = light })
        table.insert(extrusions, drawn.extrusion)
      end
    end
    own_shadow(extrusions, r.unlit[extruder], seen)
  end)

  for i, batch in ipairs(batches) do
    local group = #batches > 1 and (", group " .. i) or ""

    pass("3. hidden back faces of the volumes +1, hidden front faces -1" .. group, function()
      gl.StencilFunc(gl.ALWAYS, 0, 0)
      gl.StencilOpSeparate(gl.BACK, gl.KEEP, gl.INCR_WRAP, gl.KEEP)
      gl.StencilOpSeparate(gl.FRONT, gl.KEEP, gl.DECR_WRAP, gl.KEEP)
      for _, drawn in ipairs(batch) do drawn.extrusion:draw(r.extrude[extruder], seen) end
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
  gl.DepthMask(true)
  gl.StencilOp(gl.KEEP, gl.KEEP, gl.KEEP)
  gl.Disable(gl.POLYGON_OFFSET_FILL)

  pass("4. the scene, dark", function()
    gl.Clear(gl.DEPTH_BUFFER_BIT)
    gl.Disable(gl.STENCIL_TEST)
    scene:draw(r.phong, { view = view, projection = projection, light = light, lit = 0, ambient = r.params.darkness })
  end)

  pass("5. the lit part of the scene", function()
    gl.Enable(gl.STENCIL_TEST)
    gl.StencilFunc(gl.EQUAL, 0, 0xFF)
    gl.DepthFunc(gl.LEQUAL)
    scene:draw(r.phong, { view = view, projection = projection, light = light, lit = 1, ambient = 0.25 })
  end)
end

return recipe
