-- A shadow in its receiver's plane has the receiver's depth up to rounding, so the depth test is
-- decided by noise. Four panels of one scene: a wall that faces the camera, where depth hardly
-- changes from pixel to pixel, and a floor at a grazing angle, where it changes fast.
--
--   no offset              PolygonOffset(-1, -1)
--   factor -1 alone        units -1 alone
--
-- The offset is m · factor + r · units (m the larger of |dz/dx| and |dz/dy|, r the depth buffer's
-- resolution). Factor alone is nothing where m is 0: the wall. Units alone are less than the noise
-- where the depths of neighbouring pixels are far apart: the floor. One unit only tells apart depths
-- that were equal, and the transformation's own rounding may be larger: the lecture's -1, -1 leaves a
-- few specks on the wall, and --set units=-4 removes them. The factor has its price: the floor's shadow
-- comes forward by the depth of a pixel, over the wall's lowest row, behind which its plane goes on.
local recipe = {
  title   = "Z-fighting and polygon offset",
  lecture = "000_178f3ee06912f876: Z-fighting; Evitar problemes de z-fighting",
  scene   = "corner",
  params  = {
    light  = param.point(1.6, 2.9, 3.2),
    factor = param.number(-1, -16, 16),
    units  = param.number(-1, -16, 16),
  },
}

-- Whether a panel takes the factor and the units: 1 or 0.
local panels = {
  { name = "no offset",                  column = 0, row = 1, factor = 0, units = 0 },
  { name = "offset of factor and units", column = 1, row = 1, factor = 1, units = 1 },
  { name = "offset of factor alone",     column = 0, row = 0, factor = 1, units = 0 },
  { name = "offset of units alone",      column = 1, row = 0, factor = 0, units = 1 },
}

function recipe.setup(r)
  r.phong = shader.load "phong"
  r.planar = shader.load "planar"
end

local function draw_scene(r, panel, view, projection)
  local scene, light = r.scene, r.params.light
  gl.ClearColor(0.85, 0.88, 0.92, 1)
  gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
  gl.Enable(gl.DEPTH_TEST)
  scene.receiver:draw(r.phong, { view = view, projection = projection, light = light })

  gl.Enable(gl.POLYGON_OFFSET_FILL)
  gl.PolygonOffset(panel.factor * r.params.factor, panel.units * r.params.units)
  gl.Enable(gl.CLIP_DISTANCE0)
  for _, receiver in ipairs(scene.receivers) do
    local onto_plane = shadow.planar(receiver.plane, light)
    local above = shadow.plane_toward(receiver.plane, light)
    for _, caster in ipairs(scene.casters) do
      caster:draw(r.planar, { view = view, projection = projection,
                              model = onto_plane * caster.model,
                              above = caster.model:transpose() * above,
                              color = receiver.color * 0.25 })
    end
  end
  gl.Disable(gl.CLIP_DISTANCE0)
  gl.Disable(gl.POLYGON_OFFSET_FILL)

  scene.caster:draw(r.phong, { view = view, projection = projection, light = light })
end

function recipe.draw(r)
  local width, height = r.width // 2, r.height // 2
  local camera = r.scene.camera
  local view, projection = camera:view(), camera:projection(width / height)

  gl.ClearColor(0.15, 0.15, 0.18, 1)
  gl.Clear(gl.COLOR_BUFFER_BIT)
  for number, panel in ipairs(panels) do
    pass(number .. ". " .. panel.name, function()
      local x, y = panel.column * width, panel.row * height
      gl.Viewport(x, y, width, height)
      -- The viewport bounds what is drawn, but gl.Clear heeds the scissor box alone. A pixel's
      -- margin is left dark around each panel.
      gl.Enable(gl.SCISSOR_TEST)
      gl.Scissor(x + 1, y + 1, width - 2, height - 2)
      draw_scene(r, panel, view, projection)
    end)
  end
end

return recipe
