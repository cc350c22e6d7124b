-- The texture unit compares: a sampler2DShadow gives 1 where its third coordinate compares with the
-- stored depth as TEXTURE_COMPARE_FUNC says, else 0. LEQUAL lights what is no farther than the map's
-- depth; the other seven show what they answer.
local draw_lit = require "parts.draw_lit"
local map_limit = require "parts.map_limit"
local map_pass = require "parts.map_pass"

local recipe = {
  title   = "A shadow sampler and its eight comparisons",
  lecture = "003_dcbdf1292070997a: Shadow Mapping, muestreadores de sombra",
  scene   = "table",
  truth   = "hard",
  params  = {
    light   = param.point(2, 4, 1),
    size    = param.integer(1024, 16, 4096),
    compare = param.choice("LEQUAL", "LESS", "GEQUAL", "GREATER", "EQUAL", "NOTEQUAL", "ALWAYS", "NEVER"),
    bias    = param.choice("offset", "none"),
  },
  sweep   = { size = { 256, 512, 1024, 2048, 4096 } },
}

function recipe.holds(r)
  return pcall(shadow.light_view, r.params.light, r.scene)
end

function recipe.limit(r)
  local _, projection = shadow.light_view(r.params.light, r.scene)
  return map_limit({ { projection = projection } }, r.params.size)
end

function recipe.setup(r)
  r.size = r.params.size
  r.depth = shader.load "flat"
  r.mapped = shader.load "shadow_map_sampler"
end

function recipe.draw(r)
  local scene, camera, light, size = r.scene, r.scene.camera, r.params.light, r.size
  local light_view, light_projection = shadow.light_view(light, scene)
  local bias = shadow.map_bias(light_projection, size)
  local map = map_pass.kept(r, bias.read, size)

  if bias.read then
    pass("1. the map", function()
      map_pass.draw(r, r.frame, size, scene.caster, r.depth, light_view, light_projection,
                    r.params.bias == "offset" and bias or nil)
    end)
  end

  pass("2. the scene, by textureProj", function()
    local view, projection = camera:view(), camera:projection(r.width / r.height)
    gl.BindTexture(gl.TEXTURE_2D, map)
    gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_COMPARE_MODE, gl.COMPARE_REF_TO_TEXTURE)
    gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_COMPARE_FUNC, gl[r.params.compare])
    gl.ClearColor(0.85, 0.88, 0.92, 1)
    gl.Enable(gl.DEPTH_TEST)
    gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
    -- The matrix that the slide has, from [-1, 1]³ to [0, 1]³, after the light's own.
    draw_lit(scene, r.mapped, {
      view = view, projection = projection, light = light, shadow_map = 0,
      light_matrix = shadow.bias_matrix() * light_projection * light_view * view:inverse(),
      reach = r.params.bias == "offset" and bias.reach or 0,
    })
  end)
end

return recipe
