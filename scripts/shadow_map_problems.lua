-- What goes wrong with a shadow map, one defect at a time: each switch spoils one thing of a map that
-- is otherwise right.
--
--   acne           no bias: lit surfaces shadow themselves in stripes
--   peter_panning  a bias of three tenths of the map's depth: shadows come off what casts them
--   aliasing       a map of 64 texels: steps along the shadow's edge
--   too_small      a light volume of half the casters' extent: shadows are cut off
--   too_loose      a light volume eight times as wide: one texel in 64 is used
--   near_too_near  a near plane a million times too near: a perspective's depths crowd at 1, until
--                  those of caster and receiver are one number, and the offset is larger than the scene
local draw_lit = require "parts.draw_lit"
local map_pass = require "parts.map_pass"

local recipe = {
  title   = "The problems of shadow maps",
  lecture = "003_dcbdf1292070997a: Problemas del Shadow Mapping; 000, 001",
  scene   = "table",
  truth   = "hard",
  params  = {
    light  = param.point(2, 4, 1),
    size   = param.integer(1024, 16, 4096),
    defect = param.choice("none", "acne", "peter_panning", "aliasing", "too_small", "too_loose",
                          "near_too_near"),
  },
}

function recipe.holds(r)
  return pcall(shadow.light_view, r.params.light, r.scene)
end

function recipe.setup(r)
  r.depth = shader.load "flat"
  r.mapped = shader.load "shadow_map"
  r.size = r.params.defect == "aliasing" and 64 or r.params.size
end

-- Clip space scaled around its middle: a light volume 1/factor as wide.
local function narrowed(projection, factor)
  return mat4.scale(factor, factor, 1) * projection
end

-- The perspective with the same window and far plane, and another near plane.
local function with_near(projection, near, far)
  local rows = { projection:row(1), projection:row(2),
                 vec4(0, 0, -(far + near) / (far - near), -2 * far * near / (far - near)),
                 projection:row(4) }
  return mat4.rows(table.unpack(rows))
end

function recipe.draw(r)
  local scene, camera, light, size, defect = r.scene, r.scene.camera, r.params.light, r.size, r.params.defect
  local light_view, light_projection, near, far = shadow.light_view(light, scene)
  if defect == "too_small" then light_projection = narrowed(light_projection, 2) end
  if defect == "too_loose" then light_projection = narrowed(light_projection, 1 / 8) end
  if defect == "near_too_near" and light.w > 0 then
    light_projection = with_near(light_projection, near / 1e6, far)
  end
  local recommended = shadow.map_bias(light_projection, size)
  local bias = defect ~= "acne" and recommended or nil
  local map = map_pass.kept(r, recommended.read, size)

  if recommended.read then
    pass("1. the map" .. (defect ~= "none" and ", with " .. defect or ""), function()
      map_pass.draw(r, r.frame, size, scene.caster, r.depth, light_view, light_projection, bias)
    end)
  end

  pass("2. the scene", function()
    local view, projection = camera:view(), camera:projection(r.width / r.height)
    gl.BindTexture(gl.TEXTURE_2D, map)
    gl.ClearColor(0.85, 0.88, 0.92, 1)
    gl.Enable(gl.DEPTH_TEST)
    gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
    draw_lit(scene, r.mapped, {
      view = view, projection = projection, light = light, shadow_map = 0,
      light_matrix = shadow.bias_matrix() * light_projection * light_view * view:inverse(),
      reach = bias and bias.reach or 0, bias = defect == "peter_panning" and 0.3 or 0,
    })
  end)
end

return recipe
