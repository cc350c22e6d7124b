-- Shadows that harden toward the contact, from one map of the light's middle: a search for blockers
-- says how far before the receiver they are, and that how wide to filter. Right for one blocker parallel
-- to the light; several at different depths are taken for one at their mean.
local draw_lit = require "parts.draw_lit"
local map_pass = require "parts.map_pass"

local recipe = {
  title   = "Percentage-closer soft shadows",
  lecture = "003_dcbdf1292070997a: la sombra más cercana al oclusor está más definida",
  scene   = "table",
  truth   = "soft",
  params  = {
    light  = param.point(2, 4, 1),
    radius = param.number(0.25, 0.001, 4),    -- of the light; half the side of a square one
    shape  = param.choice("sphere", "square"),
    size   = param.integer(1024, 16, 4096),
    taps   = param.integer(12, 1, 32),        -- squared: 144 for the search, and as many to filter
  },
  sweep   = { taps = { 4, 8, 16, 32 } },
}

-- The square is parallel to the map, and both have a place.
function recipe.holds(r)
  return r.params.light.w > 0 and pcall(shadow.light_view, r.params.light, r.scene)
end

function recipe.setup(r)
  r.size = r.params.size
  r.depth = shader.load "flat"
  r.mapped = shader.load "shadow_map_pcss"
end

function recipe.draw(r)
  local scene, camera, light, size = r.scene, r.scene.camera, r.params.light, r.size
  -- With room around the casters for the parts of them that only the light's edge sees.
  local light_view, light_projection, near, far = shadow.light_view(light, scene, { radius = r.params.radius })
  local bias = shadow.map_bias(light_projection, size, 2)
  local map = map_pass.kept(r, bias.read, size)

  if bias.read then
    pass("1. the map, from the middle of the light", function()
      map_pass.draw(r, r.frame, size, scene.caster, r.depth, light_view, light_projection, bias)
    end)
  end

  pass("2. the scene: search, then filter", function()
    local view, projection = camera:view(), camera:projection(r.width / r.height)
    gl.BindTexture(gl.TEXTURE_2D, map)
    gl.ClearColor(0.85, 0.88, 0.92, 1)
    gl.Enable(gl.DEPTH_TEST)
    gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
    draw_lit(scene, r.mapped, {
      view = view, projection = projection, light = light, shadow_map = 0,
      light_matrix = shadow.bias_matrix() * light_projection * light_view * view:inverse(),
      half_width = r.params.radius, taps = r.params.taps,
      sphere = r.params.shape == "sphere", near = near, far = far,
      per_tangent = vec2(light_projection:row(1).x, light_projection:row(2).y) / 2,
    })
  end)
end

return recipe
