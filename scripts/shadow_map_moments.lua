-- Maps that can be filtered before they are read, since they store moments of depth instead of depths:
-- two (variance), two of each of two exponentials (exponential variance), or four. Blurred once, they
-- cost one lookup a pixel whatever the width. Their price is light that leaks where shadows overlap.
local draw_lit = require "parts.draw_lit"
local map_limit = require "parts.map_limit"

local recipe = {
  title   = "Moment shadow maps",
  lecture = "003_dcbdf1292070997a: PCF, and what filters before the comparison",
  scene   = "table",
  truth   = "hard",
  params  = {
    light = param.point(2, 4, 1),
    size  = param.integer(1024, 16, 4096),
    reach = param.integer(2, 0, 32),                 -- the blur is 2 · reach + 1 texels wide
    kind  = param.choice("variance", "exponential", "four"),
  },
  sweep   = { reach = { 1, 2, 4, 8 } },
}

function recipe.holds(r)
  return pcall(shadow.light_view, r.params.light, r.scene)
end

-- Of what one blocker hides; where blockers at two depths are under one filter, light leaks without a bound but 1.
function recipe.limit(r)
  local _, projection = shadow.light_view(r.params.light, r.scene)
  return map_limit({ { projection = projection } }, r.params.size, 2 * r.params.reach + 2)
end

function recipe.setup(r)
  local size = r.params.size
  r.moments, r.blur = shader.load "moments", shader.load "box_blur"
  r.mapped = shader.load "shadow_map_moments"
  r.quad = mesh.quad()
  r.fbo, r.map = fbo.color(size, size, gl.RGBA32F)
  r.half_fbo, r.half_map = fbo.color(size, size, gl.RGBA32F)
  r.depth = gl.GenRenderbuffers(1)
  gl.BindRenderbuffer(gl.RENDERBUFFER, r.depth)
  gl.RenderbufferStorage(gl.RENDERBUFFER, gl.DEPTH_COMPONENT24, size, size)
  gl.BindFramebuffer(gl.FRAMEBUFFER, r.fbo)
  gl.FramebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, r.depth)
  gl.BindTexture(gl.TEXTURE_2D, r.map)
  gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR)
  gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.LINEAR)
end

function recipe.draw(r)
  local scene, camera, light, size = r.scene, r.scene.camera, r.params.light, r.params.size
  local light_view, light_projection, near, far = shadow.light_view(light, scene)
  -- Room around the casters for the blur.
  local room = 1 - 2 * (r.params.reach + 1) / size
  light_projection = mat4.scale(room, room, 1) * light_projection
  local kind = ({ variance = 0, exponential = 1, four = 2 })[r.params.kind]
  local farthest = kind == 1 and { math.exp(20), math.exp(40), -math.exp(-20), math.exp(-40) } or { 1, 1, 1, 1 }

  pass("1. the moments of depth, of receivers too: a filter needs what is behind an edge", function()
    gl.BindFramebuffer(gl.FRAMEBUFFER, r.fbo)
    gl.Viewport(0, 0, size, size)
    gl.ClearBufferfv(gl.COLOR, 0, farthest)
    gl.Clear(gl.DEPTH_BUFFER_BIT)
    gl.Enable(gl.DEPTH_TEST)
    scene:draw(r.moments, { view = light_view, projection = light_projection, near = near, far = far,
                            kind = kind })
    gl.Disable(gl.DEPTH_TEST)
  end)

  if r.params.reach > 0 then
    pass("2. blurred, along x and along y", function()
      gl.BindFramebuffer(gl.FRAMEBUFFER, r.half_fbo)
      gl.BindTexture(gl.TEXTURE_2D, r.map)
      r.quad:draw(r.blur, { image = 0, along = vec2(1, 0), reach = r.params.reach })
      gl.BindFramebuffer(gl.FRAMEBUFFER, r.fbo)
      gl.BindTexture(gl.TEXTURE_2D, r.half_map)
      r.quad:draw(r.blur, { image = 0, along = vec2(0, 1), reach = r.params.reach })
    end)
  end

  pass("3. the scene, with what the moments allow", function()
    local view, projection = camera:view(), camera:projection(r.width / r.height)
    gl.BindFramebuffer(gl.FRAMEBUFFER, 0)
    gl.Viewport(0, 0, r.width, r.height)
    gl.BindTexture(gl.TEXTURE_2D, r.map)
    gl.Enable(gl.DEPTH_TEST)
    gl.ClearColor(0.85, 0.88, 0.92, 1)
    gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
    draw_lit(scene, r.mapped, {
      view = view, projection = projection, light = light, shadow_map = 0, kind = kind,
      light_matrix = shadow.bias_matrix() * light_projection * light_view * view:inverse(),
      near = near, far = far, perspective = light.w > 0,
    })
  end)
end

return recipe
