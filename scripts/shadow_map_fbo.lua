-- A shadow map in a framebuffer object of its own, for a directional light: no window limits its size,
-- nothing is copied, and no colour is drawn.
local draw_lit = require "parts.draw_lit"
local map_limit = require "parts.map_limit"
local map_pass = require "parts.map_pass"
local still = require "parts.still"

local recipe = {
  title   = "A shadow map in a framebuffer object",
  lecture = "001_863ae27a0c0eacfb: El mapeig d'ombres",
  scene   = "table",
  truth   = "hard",
  params  = {
    light    = param.direction(2, 4, 1),
    size     = param.integer(1024, 16, 4096),
    -- The light's projection: fitted to what matters, or the lesson's ortho(-10, 10, -10, 10, 1, 7.5)
    -- seen from the light's direction.
    coverage = param.choice("fitted", "lesson"),
    -- Against acne: an offset of the map's depths and of the fragment's, each by its own slope, or of the
    -- fragment's place along its normal.
    bias     = param.choice("offset", "normal", "none"),
    -- A map that holds all shadows, not only those in view, is drawn again only where the light or a
    -- caster has moved: every camera and every frame share it.
    keep     = param.toggle(false),
  },
  sweep   = { size = { 256, 512, 1024, 2048, 4096 } },
}

function recipe.holds(r)
  return pcall(shadow.light_view, r.params.light, r.scene)
end

function recipe.limit(r)
  local _, projection = shadow.light_view(r.params.light, r.scene, { fit = r.params.keep and "scene" or "view" })
  return map_limit({ { projection = projection } }, r.params.size)
end

-- The map, made when somebody reads it.
local function make_map(r, size)
  r.fbo = gl.GenFramebuffers(1)
  -- The depth texture
  r.map = gl.GenTextures(1)
  gl.BindTexture(gl.TEXTURE_2D, r.map)
  gl.TexImage2D(gl.TEXTURE_2D, 0, gl.DEPTH_COMPONENT, size, size, 0, gl.DEPTH_COMPONENT, gl.FLOAT, nil)
  gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST)
  gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST)
  -- Outside of the map there is no shadow: the border is as far as can be.
  gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_BORDER)
  gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_BORDER)
  gl.TexParameterfv(gl.TEXTURE_2D, gl.TEXTURE_BORDER_COLOR, { 1, 1, 1, 1 })
  -- Attached to the framebuffer, which draws no colour
  gl.BindFramebuffer(gl.FRAMEBUFFER, r.fbo)
  gl.FramebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.TEXTURE_2D, r.map, 0)
  gl.DrawBuffer(gl.NONE)
  gl.ReadBuffer(gl.NONE)
  if gl.CheckFramebufferStatus(gl.FRAMEBUFFER) ~= gl.FRAMEBUFFER_COMPLETE then
    error "the shadow map's framebuffer is not complete"
  end
  gl.BindFramebuffer(gl.FRAMEBUFFER, 0)
end

function recipe.setup(r)
  r.size, r.bias = r.params.size, r.params.bias   -- what a map that is kept was made for
  r.depth = shader.load "flat"
  r.mapped = shader.load "shadow_map"
  r.shown = {}
end

function recipe.draw(r)
  local scene, camera, light, size = r.scene, r.scene.camera, r.params.light, r.size
  local light_view, light_projection
  if r.params.coverage == "lesson" then
    light_projection = mat4.ortho(-10, 10, -10, 10, 1, 7.5)
    light_view = mat4.look_at(light.xyz, vec3(0), vec3(0, 1, 0))
  else
    light_view, light_projection = shadow.light_view(light, scene, { fit = r.params.keep and "scene" or "view" })
  end
  local bias = shadow.map_bias(light_projection, size)
  if bias.read and not r.map then make_map(r, size) end

  gl.Enable(gl.DEPTH_TEST)
  if bias.read and not (r.params.keep and still(r.shown, light_projection * light_view, scene.casters)) then
    pass("1. depth, from the light", function()
      gl.Viewport(0, 0, size, size)
      gl.BindFramebuffer(gl.FRAMEBUFFER, r.fbo)
      gl.Clear(gl.DEPTH_BUFFER_BIT)
      if r.bias == "offset" then
        gl.Enable(gl.POLYGON_OFFSET_FILL)
        gl.PolygonOffset(bias.factor, bias.units)
      end
      -- The lesson draws the whole scene; what casts no shadow can be left out.
      scene.caster:draw(r.depth, { view = light_view, projection = light_projection })
      gl.Disable(gl.POLYGON_OFFSET_FILL)
      gl.BindFramebuffer(gl.FRAMEBUFFER, 0)
    end)
  end

  pass("2. the scene, with the map", function()
    local view, projection = camera:view(), camera:projection(r.width / r.height)
    gl.Viewport(0, 0, r.width, r.height)
    gl.ClearColor(0.85, 0.88, 0.92, 1)
    gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
    gl.ActiveTexture(gl.TEXTURE1)
    gl.BindTexture(gl.TEXTURE_2D, bias.read and r.map or map_pass.kept(r, false, 1))
    draw_lit(scene, r.mapped, {
      view = view, projection = projection, light = light, shadow_map = 1,
      light_matrix = shadow.bias_matrix() * light_projection * light_view * view:inverse(),
      normal_offset = r.bias == "normal" and bias.normal_offset or 0,
      reach = r.bias == "offset" and bias.reach or 0,
    })
  end)
end

return recipe
