-- Soft shadows as textures of their receivers. The matrix of Heckbert and Herf maps what is between a
-- point of the light and a receiver's parallelogram onto the unit square, each place to where its
-- shadow falls. So a texture of the receiver takes the casters as seen from one point after the other,
-- all in register, and their sum is the soft shadow, for as long as neither light nor casters move:
-- the view may. (P. Heckbert, M. Herf, Simulating Soft Shadows with Graphics Hardware, 1997. They
-- accumulate the receiver's shaded picture; here it is the hidden share of the light alone.)
local lamp = require "parts.lamp"

local recipe = {
  title   = "Soft shadow textures, one for each receiver",
  lecture = "beyond the lectures: Heckbert and Herf 1997; 002_b957b372f85420d1: Soft shadows",
  scene   = "room",
  truth   = "soft on receivers",
  params  = {
    light    = param.point(0.2, 2.1, 0.9),
    radius   = param.number(0.2, 0, 4),        -- of the light; half the side of a square one
    shape    = param.choice("sphere", "square", "disk"),
    samples  = param.integer(64, 1, 4096),
    pattern  = param.choice("hammersley", "random", "jitter", "grid", "r2", "sobol", "owen"),
    seed     = param.integer(1, 0, 1000000),
    size     = param.integer(512, 16, 4096),   -- of each texture
    darkness = param.number(0.25, 0, 1),
  },
  keys      = { ["["] = "multiply samples 0.5", ["]"] = "multiply samples 2", p = "next pattern",
                ["+"] = "multiply radius 1.25", ["-"] = "multiply radius 0.8" },
  sweep     = { samples = { 1, 4, 16, 64, 256 } },
}

-- The receivers must be rectangles in a plane y of their own space, as mesh.plane is.
local function is_rectangle(receiver) return receiver.mesh.low.y == receiver.mesh.high.y end

-- Its corner in the world, and the sides from there.
local function parallelogram_of(receiver)
  local low, high = receiver.mesh.low, receiver.mesh.high
  local to_world = function(x, z) return receiver.model:transform_point(vec3(x, low.y, z)) end
  local corner = to_world(low.x, low.z)
  return corner, to_world(high.x, low.z) - corner, to_world(low.x, high.z) - corner
end

function recipe.holds(r)
  for _, receiver in ipairs(r.scene.receivers) do
    if not is_rectangle(receiver) then return false end
  end
  return r.params.light.w ~= 0
end

function recipe.points(r)
  local params = r.params
  return shadow.samples(lamp(params.light, params.shape, params.radius), params.samples, params.pattern, params.seed)
end

-- A texel's bilinear filter reads up to one texel to each side: so far the shadow may be off on its receiver.
function recipe.limit(r)
  local texel = 0
  for _, receiver in ipairs(r.scene.receivers) do
    local _, ex, ey = parallelogram_of(receiver)
    texel = math.max(texel, (ex:length() + ey:length()) / r.params.size)
  end
  return { on_receiver = texel }
end

function recipe.setup(r)
  local size = r.params.size
  r.phong = shader.load "phong"
  r.caster = shader.load "soft_caster"
  r.receiver = shader.load "soft_receiver"
  -- One depth buffer serves all: they are drawn one after the other.
  r.depth = gl.GenRenderbuffers(1)
  gl.BindRenderbuffer(gl.RENDERBUFFER, r.depth)
  gl.RenderbufferStorage(gl.RENDERBUFFER, gl.DEPTH_COMPONENT24, size, size)
  r.shadows = {}
  for i, receiver in ipairs(r.scene.receivers) do
    if not is_rectangle(receiver) then error(receiver.name .. " is not a rectangle in a plane y of its own") end
    local corner, ex, ey = parallelogram_of(receiver)
    local frame, texture = fbo.color(size, size, gl.R32F)
    gl.BindFramebuffer(gl.FRAMEBUFFER, frame)
    gl.FramebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, r.depth)
    gl.BindTexture(gl.TEXTURE_2D, texture)
    gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR)
    gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.LINEAR)
    gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE)
    gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE)
    r.shadows[i] = { frame = frame, texture = texture, corner = corner, ex = ex, ey = ey }
  end
  gl.BindFramebuffer(gl.FRAMEBUFFER, 0)
end

-- The casters as seen from each point: what hides it adds its share, once.
local function draw_shadows(r, receiver, shadows, points)
  local to_clip = shadow.bias_matrix():inverse()
  gl.BindFramebuffer(gl.FRAMEBUFFER, shadows.frame)
  gl.Viewport(0, 0, r.params.size, r.params.size)
  gl.ClearColor(0, 0, 0, 0)
  gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
  gl.Enable(gl.DEPTH_TEST)
  gl.Enable(gl.BLEND)
  gl.BlendFunc(gl.ONE, gl.ONE)
  -- A caster may be at the light: nothing is cut off before it, and by its plane what is behind the receiver.
  gl.Enable(gl.DEPTH_CLAMP)
  gl.Enable(gl.CLIP_DISTANCE0)
  for i, point in ipairs(points) do
    -- A point in the receiver's plane throws nothing onto it.
    if math.abs(receiver.plane:dot(point)) > 1e-9 then
      -- All of a point's shadow is at one depth, nearer than the last one's. So a second face over the same
      -- texel adds nothing, and the next point's does, without clearing in between.
      local depth = 1 - i / (#points + 1)
      gl.DepthRange(depth, depth)
      local view = shadow.parallelogram(shadows.corner, shadows.ex, shadows.ey, point)
      local above = shadow.plane_toward(receiver.plane, point)
      for _, caster in ipairs(r.scene.casters) do
        caster:draw(r.caster, { view = view, projection = to_clip, above = caster.model:transpose() * above,
                                color = vec3(1 / #points) })
      end
    end
  end
  gl.DepthRange(0, 1)
  gl.Disable(gl.CLIP_DISTANCE0)
  gl.Disable(gl.DEPTH_CLAMP)
  gl.Disable(gl.BLEND)
  gl.BindFramebuffer(gl.FRAMEBUFFER, 0)
  gl.Viewport(0, 0, r.width, r.height)
end

function recipe.draw(r)
  local scene, params, light = r.scene, r.params, r.params.light
  local points = recipe.points(r)

  for i, receiver in ipairs(scene.receivers) do
    pass("the shadow's texture, " .. receiver.name, function()
      draw_shadows(r, receiver, r.shadows[i], points)
    end)
  end

  pass("the scene", function()
    local seen = { view = scene.camera:view(), projection = scene.camera:projection(r.width / r.height),
                   light = light, ambient = params.darkness }
    gl.ClearColor(0.85, 0.88, 0.92, 1)
    gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
    for _, caster in ipairs(scene.casters) do caster:draw(r.phong, seen) end
    seen.hidden = 0
    for i, receiver in ipairs(scene.receivers) do
      local low, high = receiver.mesh.low, receiver.mesh.high
      gl.BindTexture(gl.TEXTURE_2D, r.shadows[i].texture)
      seen.corner, seen.sides = vec2(low.x, low.z), vec2(high.x - low.x, high.z - low.z)
      receiver:draw(r.receiver, seen)
    end
  end)
end

return recipe
