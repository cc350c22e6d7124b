-- The hard shadow of volumes, made soft in the picture. A light with a size leaves a penumbra that
-- starts at nothing where a caster touches the receiver and widens with the distance from there.
--   none     the hard shadow
--   even     blurred all alike: too soft at the contact, too hard far from it
--   contact  one more pass draws the volume's sides into a framebuffer object, where each knows how far
--            from the light its edge is; the blur's width follows from that
-- What the picture does not show cannot be blurred in: where the outline of a shadow is hidden, or
-- beyond the border, or beyond the receiver's end, it stays as it is. Where outlines of casters near and
-- far cross, one width stands for both. A light that reaches into a caster is no light.
local batches_of = require "parts.batches"
local own_shadow = require "parts.own_shadow"
local scene_depth = require "parts.scene_depth"

local recipe = {
  title   = "Shadow volumes, blurred edges",
  lecture = "004_502e9deeb91da7bb: Un peu de flou sur les contours; un flou qui dépend de la distance au point de contact",
  scene   = "table",
  truth   = "soft",
  params  = {
    light    = param.point(2, 4, 1),
    radius   = param.number(0.25, 0.001, 4),  -- of the light, a sphere
    blur     = param.choice("contact", "even", "none"),
    width    = param.number(6, 0, 64),        -- of the even blur, pixels
    darkness = param.number(0.25, 0, 1),
  },
}

-- A lamp has a radius; for a direction there is none.
function recipe.holds(r) return r.params.light.w ~= 0 end

-- A floating-point texture of the picture's size.
local function texture(r, format)
  local name = gl.GenTextures(1)
  gl.BindTexture(gl.TEXTURE_2D, name)
  gl.TexStorage2D(gl.TEXTURE_2D, 1, format, r.width, r.height)
  gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST)
  gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST)
  return name
end

-- A framebuffer object of these textures and a depth buffer.
local function framebuffer(r, ...)
  local name, depth = gl.GenFramebuffers(1), gl.GenRenderbuffers(1)
  gl.BindFramebuffer(gl.FRAMEBUFFER, name)
  local buffers = {}
  for i, color in ipairs{ ... } do
    buffers[i] = gl.COLOR_ATTACHMENT0 + i - 1
    gl.FramebufferTexture2D(gl.FRAMEBUFFER, buffers[i], gl.TEXTURE_2D, color, 0)
  end
  gl.BindRenderbuffer(gl.RENDERBUFFER, depth)
  gl.RenderbufferStorage(gl.RENDERBUFFER, gl.DEPTH_COMPONENT24, r.width, r.height)
  gl.FramebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, depth)
  gl.DrawBuffers(#buffers, buffers)
  return name
end

function recipe.setup(r)
  for _, name in ipairs{ "phong", "volume", "flat", "surface", "contact", "flood", "blur" } do
    r[name] = shader.load(name)
  end
  r.quad = mesh.quad()
  r.where, r.normals = texture(r, gl.RGBA32F), texture(r, gl.RGBA32F)
  r.soft, r.hard = texture(r, gl.R32F), texture(r, gl.RGBA8)
  r.seen_target = framebuffer(r, r.where, r.normals)
  r.outlines, r.outline_targets = {}, {}
  for i = 1, 2 do
    r.outlines[i] = texture(r, gl.RGBA32F)
    r.outline_targets[i] = framebuffer(r, r.outlines[i])
  end
  r.soft_target = framebuffer(r, r.soft)
  gl.BindFramebuffer(gl.FRAMEBUFFER, 0)
end

-- Steps 1 to 3 of z-fail: the stencil is 0 where the centre of the light is seen.
local function count_volumes(r, seen)
  pass("1. the scene in the depth buffer", function()
    gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT)
    gl.Enable(gl.DEPTH_TEST)
    gl.ColorMask(false, false, false, false)
    scene_depth.draw(r.scene.objects, r.phong, seen)
  end)

  gl.DepthMask(false)
  local volumes = {}
  local batches = batches_of(r.scene.casters, seen.light)
  pass("2. sides turned from the light are in their own shadow", function()
    for _, batch in ipairs(batches) do
      for _, drawn in ipairs(batch) do
        drawn.volume = shadow.volume(drawn.caster, nil, seen.light, { part = drawn.part })
        table.insert(volumes, drawn.volume)
      end
    end
    own_shadow(volumes, r.volume, seen)
  end)

  for i, batch in ipairs(batches) do
    local group = #batches > 1 and (", group " .. i) or ""

    pass("3. hidden back faces of the volumes +1, hidden front faces -1" .. group, function()
      gl.StencilFunc(gl.ALWAYS, 0, 0)
      gl.StencilOpSeparate(gl.BACK, gl.KEEP, gl.INCR_WRAP, gl.KEEP)
      gl.StencilOpSeparate(gl.FRONT, gl.KEEP, gl.DECR_WRAP, gl.KEEP)
      for _, drawn in ipairs(batch) do drawn.volume:draw(r.volume, seen) end
    end)

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
  return volumes
end

local function bind(unit, name)
  gl.ActiveTexture(gl.TEXTURE0 + unit)
  gl.BindTexture(gl.TEXTURE_2D, name)
end

function recipe.draw(r)
  local scene, light, camera = r.scene, r.params.light, r.scene.camera
  local view = camera:view()
  local projection = shadow.infinite_perspective(camera.fovy, r.width / r.height, camera.near)
  local seen = { view = view, projection = projection, light = light }
  local volumes = count_volumes(r, seen)
  local nearest = r.outlines[1]

  pass("4. the hard shadow as a texture", function()
    gl.Disable(gl.POLYGON_OFFSET_FILL)
    gl.Disable(gl.DEPTH_TEST)
    gl.ColorMask(true, true, true, true)
    gl.StencilFunc(gl.EQUAL, 0, 0xFF)
    gl.StencilOp(gl.KEEP, gl.KEEP, gl.KEEP)
    r.quad:draw(r.flat, { color = vec3(1), alpha = 1 })
    bind(0, r.hard)
    gl.CopyTexSubImage2D(gl.TEXTURE_2D, 0, 0, 0, 0, 0, r.width, r.height)
    gl.Disable(gl.STENCIL_TEST)
  end)

  if r.params.blur ~= "none" then
    gl.Enable(gl.DEPTH_TEST)
    gl.DepthMask(true)

    pass("5. where each pixel is, and its normal", function()
      gl.BindFramebuffer(gl.FRAMEBUFFER, r.seen_target)
      gl.ClearColor(0, 0, 0, 0)
      gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
      for _, object in ipairs(scene.objects) do
        object:draw(r.surface, { view = view, projection = projection, casts = object.role ~= "receiver" })
      end
    end)

    if r.params.blur == "contact" then
      pass("6. the side of a volume nearest to it, and how far from the light its edge is", function()
        gl.BindFramebuffer(gl.FRAMEBUFFER, r.outline_targets[1])
        gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
        bind(0, r.where)
        bind(1, r.hard)
        for _, volume in ipairs(volumes) do
          volume:draw_sides(r.contact, { view = view, projection = projection, light = light,
                                         surface = 0, hard = 1 })
        end
      end)

      pass("7. the outline nearest to each pixel", function()
        gl.Disable(gl.DEPTH_TEST)
        local from, to = 1, 2
        local stride = 1
        while stride * 8 <= r.height do stride = stride * 2 end
        while stride >= 1 do
          gl.BindFramebuffer(gl.FRAMEBUFFER, r.outline_targets[to])
          bind(1, r.outlines[from])
          r.quad:draw(r.flood, { surface = 0, outlines = 1, stride = stride })
          from, to, stride = to, from, stride // 2
        end
        nearest = r.outlines[from]
      end)
    end

    pass("8. the hard shadow, blurred", function()
      gl.BindFramebuffer(gl.FRAMEBUFFER, r.soft_target)
      gl.Disable(gl.DEPTH_TEST)
      for unit, name in ipairs{ r.where, r.normals, r.hard, nearest } do bind(unit - 1, name) end
      r.quad:draw(r.blur, { view = view, projection = projection, light = light, radius = r.params.radius,
                            surface = 0, normals = 1, hard = 2, nearest = 3, width = r.params.width,
                            by_contact = r.params.blur == "contact" })
      gl.BindFramebuffer(gl.FRAMEBUFFER, 0)
    end)
  end

  pass("9. the scene, lit as far as the light is seen", function()
    gl.ClearColor(0.85, 0.88, 0.92, 1)
    gl.DepthMask(true)
    gl.Enable(gl.DEPTH_TEST)
    gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
    gl.DepthFunc(gl.LESS)
    bind(0, r.params.blur == "none" and r.hard or r.soft)
    scene:draw(r.phong, { view = view, projection = projection, light = light, ambient = r.params.darkness,
                          lit_by_texture = true, visibility = 0 })
  end)
end

return recipe
