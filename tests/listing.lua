-- The listings as lectures print them, on worlds of tests/given.lua: what shadowlab's pictures stand beside.
local given = require "given"

local listing = {}

-- The last of the steps: the scene in the dark, and over it what is lit: where the count is 0, or with "EQUAL 1"
-- where it is not 1.
local function shade(here, phong, seen, test)
  gl.Disable(gl.STENCIL_TEST)
  gl.ColorMask(true, true, true, true)
  gl.DepthFunc(gl.LEQUAL)
  here:draw(phong, { view = seen.view, projection = seen.projection, light = seen.light, lit = 0, ambient = 0.25 })
  gl.Enable(gl.STENCIL_TEST)
  if test == "EQUAL 1" then gl.StencilFunc(gl.NOTEQUAL, 1, 0xFF) else gl.StencilFunc(gl.EQUAL, 0, 0xFF) end
  gl.StencilOp(gl.KEEP, gl.KEEP, gl.KEEP)
  here:draw(phong, { view = seen.view, projection = seen.projection, light = seen.light, lit = 1, ambient = 0.25 })
end

-- The first: depths alone, and then nothing but the stencil is written.
local function depths(here, phong, seen)
  gl.ClearColor(0.85, 0.88, 0.92, 1)
  gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT)
  gl.Enable(gl.DEPTH_TEST)
  gl.ColorMask(false, false, false, false)
  here:draw(phong, seen)
  gl.DepthMask(false)
  gl.Enable(gl.STENCIL_TEST)
end

-- Shadow volumes of every caster's silhouette, depths as they come; `way` is "zpass" or "zfail", `test`
-- "EQUAL 1" for the slide's, `edges` "lit" for a side from each edge that one lit face has, however the
-- faces run.
function listing.volumes(world, light, way, test, edges)
  given.world = world
  return frame(given.size, given.size, function()
    local here, phong, volume = scene.load "given", shader.load "phong", shader.load "volume"
    local camera = here.camera
    local seen = { view = camera:view(), light = light,
                   projection = shadow.infinite_perspective(camera.fovy, 1, camera.near) }
    depths(here, phong, seen)
    if way == "zpass" then
      gl.StencilOpSeparate(gl.FRONT, gl.KEEP, gl.KEEP, gl.INCR_WRAP)
      gl.StencilOpSeparate(gl.BACK, gl.KEEP, gl.KEEP, gl.DECR_WRAP)
    else
      gl.StencilOpSeparate(gl.BACK, gl.KEEP, gl.INCR_WRAP, gl.KEEP)
      gl.StencilOpSeparate(gl.FRONT, gl.KEEP, gl.DECR_WRAP, gl.KEEP)
    end
    for _, caster in ipairs(here.casters) do
      local one = shadow.volume(caster, nil, light, { edges = edges, caps = way == "zfail" })
      if way == "zpass" then one:draw_sides(volume, seen) else one:draw(volume, seen) end
    end
    shade(here, phong, seen, test)
  end)
end

-- What was counted, as a picture: white where it is not 0.
function listing.show_count()
  gl.ColorMask(true, true, true, true)
  gl.Disable(gl.DEPTH_TEST)
  gl.StencilFunc(gl.NOTEQUAL, 0, 0xFF)
  gl.StencilOp(gl.KEEP, gl.KEEP, gl.KEEP)
  mesh.quad():draw(shader.load "flat", { view = mat4(1), projection = mat4(1), color = vec3(1) })
end

-- Volumes by hand, a prism for each lit face: which are lit is decided in floating point, and "far" is a
-- distance. Counted by z-fail, the far plane beyond.
function listing.prisms(world, light, distance)
  given.world = world
  return frame(given.size, given.size, function()
    local here, phong, flat = scene.load "given", shader.load "phong", shader.load "flat"
    local camera = here.camera
    local seen = { view = camera:view(), light = light,
                   projection = mat4.perspective(camera.fovy, 1, camera.near, 4 * distance) }
    depths(here, phong, seen)
    gl.StencilOpSeparate(gl.BACK, gl.KEEP, gl.INCR_WRAP, gl.KEEP)
    gl.StencilOpSeparate(gl.FRONT, gl.KEEP, gl.DECR_WRAP, gl.KEEP)
    for _, caster in ipairs(here.casters) do
      local positions, indices = {}, {}
      for t = 0, caster.mesh.triangles - 1 do
        local corners = { caster.mesh:triangle(t) }
        for i, corner in ipairs(corners) do corners[i] = caster.model:transform_point(caster.mesh:position(corner)) end
        local a, b, c = table.unpack(corners)
        if (b - a):cross(c - a):dot(light.xyz - a * light.w) > 0 then
          local first = #positions
          for _, p in ipairs(corners) do
            positions[#positions + 1] = p
            positions[#positions + 1] = p + (p * light.w - light.xyz):normalize() * distance
          end
          for _, i in ipairs{ 0, 2, 4,  1, 5, 3,  0, 1, 2,  1, 3, 2,  2, 3, 4,  3, 5, 4,  4, 5, 0,  5, 1, 0 } do
            indices[#indices + 1] = first + i
          end
        end
      end
      if #indices > 0 then mesh.new{ positions = positions, indices = indices }:draw(flat, seen) end
    end
    shade(here, phong, seen)
  end)
end

return listing
