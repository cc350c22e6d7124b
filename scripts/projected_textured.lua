-- The projected shadow by stencil, and in it another texture in place of another brightness. What
-- the stencil tells apart can be drawn in any way at all.
local recipe = {
  title   = "Another texture in the shadow",
  lecture = "004_502e9deeb91da7bb: Utilisation d'un stencil buffer",
  scene   = "table",
  params  = {
    light    = param.point(2, 4, 1),
    darkness = param.number(0.6, 0, 1),
  },
}

local side = 64

-- side × side texels, RGB, from a function of x and y in [0, 1) that gives a vec3.
local function make_texture(color_at)
  local bytes = {}
  for y = 0, side - 1 do
    for x = 0, side - 1 do
      local c = color_at((x + 0.5) / side, (y + 0.5) / side) * 255
      bytes[#bytes + 1] = string.char(c.r // 1 | 0, c.g // 1 | 0, c.b // 1 | 0)
    end
  end
  local texture = gl.GenTextures(1)
  gl.BindTexture(gl.TEXTURE_2D, texture)
  gl.TexImage2D(gl.TEXTURE_2D, 0, gl.RGB8, side, side, 0, gl.RGB, gl.UNSIGNED_BYTE,
                table.concat(bytes))
  gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR)
  gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.LINEAR)
  gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.REPEAT)
  gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.REPEAT)
  gl.GenerateMipmap(gl.TEXTURE_2D)
  return texture
end

-- Four tiles, two light and two dark, with a joint between them.
local function tiles(x, y)
  local u, v = x * 2 % 1, y * 2 % 1
  if math.min(u, v, 1 - u, 1 - v) < 0.05 then return vec3(0.60, 0.56, 0.50) end
  if (x < 0.5) == (y < 0.5) then return vec3(0.93, 0.88, 0.78) end
  return vec3(0.80, 0.55, 0.38)
end

-- Discs on a dark ground.
local function discs(x, y)
  local u, v = x * 2 % 1 - 0.5, y * 2 % 1 - 0.5
  if u * u + v * v < 0.09 then return vec3(0.98, 0.80, 0.36) end
  return vec3(0.16, 0.20, 0.38)
end

function recipe.setup(r)
  r.phong = shader.load "phong"
  r.planar = shader.load "planar"
  r.textured = shader.load "textured"
  r.tiles, r.discs = make_texture(tiles), make_texture(discs)
end

function recipe.draw(r)
  local scene, light = r.scene, r.params.light
  local view, projection = scene.camera:view(), scene.camera:projection(r.width / r.height)
  local receiver = scene.receivers[1]

  gl.ClearColor(0.85, 0.88, 0.92, 1)
  gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT)
  gl.Enable(gl.DEPTH_TEST)

  pass("1. the receiver, in one texture, marks the stencil", function()
    gl.Enable(gl.STENCIL_TEST)
    gl.StencilFunc(gl.ALWAYS, 1, 1)
    gl.StencilOp(gl.KEEP, gl.KEEP, gl.REPLACE)
    gl.BindTexture(gl.TEXTURE_2D, r.tiles)
    receiver:draw(r.textured, { view = view, projection = projection, light = light,
                                ambient = r.params.darkness, repeats = vec2(4, 3) })
  end)

  pass("2. the projected casters clear it where the shadow falls", function()
    gl.Disable(gl.DEPTH_TEST)
    gl.ColorMask(false, false, false, false)
    gl.StencilFunc(gl.EQUAL, 1, 1)
    gl.StencilOp(gl.KEEP, gl.KEEP, gl.ZERO)
    gl.Enable(gl.CLIP_DISTANCE0)
    local onto_plane = shadow.planar(receiver.plane, light)
    local above = shadow.plane_toward(receiver.plane, light)
    for _, caster in ipairs(scene.casters) do
      caster:draw(r.planar, { view = view, projection = projection,
                              model = onto_plane * caster.model,
                              above = caster.model:transpose() * above })
    end
    gl.Disable(gl.CLIP_DISTANCE0)
  end)

  pass("3. the part in shadow, in the other texture", function()
    gl.Enable(gl.DEPTH_TEST)
    gl.DepthFunc(gl.LEQUAL)
    gl.ColorMask(true, true, true, true)
    gl.StencilFunc(gl.EQUAL, 0, 1)
    gl.StencilOp(gl.KEEP, gl.KEEP, gl.KEEP)
    gl.BindTexture(gl.TEXTURE_2D, r.discs)
    receiver:draw(r.textured, { view = view, projection = projection, light = light, lit = 0,
                                ambient = r.params.darkness, repeats = vec2(4, 3) })
  end)

  pass("4. the casters", function()
    gl.DepthFunc(gl.LESS)
    gl.Disable(gl.STENCIL_TEST)
    scene.caster:draw(r.phong, { view = view, projection = projection, light = light })
  end)
end

return recipe
