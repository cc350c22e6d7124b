-- The first shadow map: the scene is drawn from the light into the frame itself, whose depth is then
-- copied into a texture. The map is no larger than the window that way; here a larger one is drawn
-- and copied in pieces, one window at a time.
local draw_lit = require "parts.draw_lit"
local map_limit = require "parts.map_limit"
local map_pass = require "parts.map_pass"

local recipe = {
  title   = "A shadow map, copied from the depth buffer",
  lecture = "000_178f3ee06912f876: Shadow mapping",
  scene   = "table",
  truth   = "hard",
  params  = {
    light = param.point(2, 4, 1),
    size  = param.integer(1024, 16, 4096),
    -- What keeps lit surfaces from shadowing themselves: the offsets that shadow.map_bias gives, of the
    -- map and of the fragment, the lecture's 1, 1, or its constant in the shader.
    bias  = param.choice("recommended", "offset 1,1", "constant 0.01"),
  },
  sweep   = { size = { 256, 512, 1024, 2048, 4096 } },
}

-- One point light's frustum holds what is on one side of it: no map where casters are all around.
function recipe.holds(r)
  return pcall(shadow.light_view, r.params.light, r.scene)
end

function recipe.limit(r)
  local _, projection = shadow.light_view(r.params.light, r.scene)
  return map_limit({ { projection = projection } }, r.params.size)
end

-- Setup shadow map (once)
local function setup_map(r, size)
  gl.ActiveTexture(gl.TEXTURE0)
  r.map = gl.GenTextures(1)
  gl.BindTexture(gl.TEXTURE_2D, r.map)
  -- Outside of the map all is lit: CLAMP_TO_EDGE, as the slide has it, draws the map's rim on.
  gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_BORDER)
  gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_BORDER)
  gl.TexParameterfv(gl.TEXTURE_2D, gl.TEXTURE_BORDER_COLOR, { 1, 1, 1, 1 })
  -- NEAREST: LINEAR would mix depths of different surfaces into one that neither has.
  gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST)
  gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST)
  gl.TexImage2D(gl.TEXTURE_2D, 0, gl.DEPTH_COMPONENT32, size, size, 0, gl.DEPTH_COMPONENT, gl.FLOAT, nil)
end

function recipe.setup(r)
  r.size = r.params.size
  r.flat = shader.load "flat"
  r.mapped = shader.load "shadow_map"
end

function recipe.draw(r)
  local scene, light, size = r.scene, r.params.light, r.size
  local light_view, light_projection = shadow.light_view(light, scene)
  local bias = shadow.map_bias(light_projection, size)

  if bias.read and not r.map then setup_map(r, size) end

  gl.Enable(gl.DEPTH_TEST)
  if bias.read then
    pass("1. the shadow map: the scene as the light sees it, copied into the texture", function()
      gl.ColorMask(false, false, false, false)
      gl.BindTexture(gl.TEXTURE_2D, r.map)
      if r.params.bias ~= "constant 0.01" then
        gl.Enable(gl.POLYGON_OFFSET_FILL)
        if r.params.bias == "offset 1,1" then gl.PolygonOffset(1, 1)
        else gl.PolygonOffset(bias.factor, bias.units) end
      end
      for y = 0, size - 1, r.height do
        for x = 0, size - 1, r.width do
          gl.Viewport(-x, -y, size, size)
          gl.Clear(gl.DEPTH_BUFFER_BIT)
          scene.caster:draw(r.flat, { view = light_view, projection = light_projection })
          gl.CopyTexSubImage2D(gl.TEXTURE_2D, 0, x, y, 0, 0,
                               math.min(r.width, size - x), math.min(r.height, size - y))
        end
      end
      gl.Disable(gl.POLYGON_OFFSET_FILL)
      gl.ColorMask(true, true, true, true)
      gl.Viewport(0, 0, r.width, r.height)
    end)
  end

  pass("2. the scene, compared with the map", function()
    local camera = scene.camera
    local view, projection = camera:view(), camera:projection(r.width / r.height)
    gl.ClearColor(0.85, 0.88, 0.92, 1)
    gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
    gl.BindTexture(gl.TEXTURE_2D, bias.read and r.map or map_pass.kept(r, false, 1))
    -- Translate(0.5) Scale(0.5) Perspective LookAt, and back from the eye to the world.
    local light_matrix = shadow.bias_matrix() * light_projection * light_view * view:inverse()
    draw_lit(scene, r.mapped, { view = view, projection = projection, light = light,
                                light_matrix = light_matrix, shadow_map = 0,
                                reach = r.params.bias == "recommended" and bias.reach or 0,
                                bias = r.params.bias == "constant 0.01" and 0.01 or 0 })
  end)
end

return recipe
