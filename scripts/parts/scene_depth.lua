-- The scene in the depth buffer, as shadow volumes are counted against it. Depth does not say exactly
-- which of two surfaces is in front: it is rounded to 24 bits, by 1/2 unit and again where the other is;
-- and since corners are moved to 1/256 of a pixel, a pixel of a face may lie 1/512 of a pixel beyond it,
-- where the face's slope takes its depth. So what is seen is pulled toward the eye by that error of its
-- own, and the volumes are pushed back by theirs (parts.own_shadow):
--  - no lit face stands in the sides of its own volume, which run close along it near the terminator;
--  - the cap in the plane that a caster stands on is behind that plane.
-- Square to the view a shadow begins late by that: 2 z^2 / (near 2^24) metres at a distance of z.
local scene_depth = {}

local function pull()
  gl.Enable(gl.POLYGON_OFFSET_FILL)
  gl.PolygonOffset(-1 / 512, -2)
end

-- Leaves 1 in the stencil where a caster is seen. A caster that touches a receiver which hides it could
-- still win a pixel there, by a side that is turned from the light: so who is seen is decided first, with
-- the casters pushed back. As far as the caps of their volumes are: what hides a caster hides its cap.
function scene_depth.draw(objects, shader, seen)
  local function draw(casts)
    for _, object in ipairs(objects) do
      if (object.role ~= "receiver") == casts then object:draw(shader, seen) end
    end
  end
  pull()
  draw(false)
  gl.Enable(gl.STENCIL_TEST)
  gl.StencilFunc(gl.ALWAYS, 1, 0xFF)
  gl.StencilOp(gl.KEEP, gl.KEEP, gl.REPLACE)
  gl.PolygonOffset(1 / 512, 0)
  draw(true)
  gl.StencilFunc(gl.EQUAL, 1, 0xFF)
  gl.StencilOp(gl.KEEP, gl.KEEP, gl.KEEP)
  pull()
  draw(true)
end

-- What is drawn from now on by the same shader meets its own depths again.
function scene_depth.match()
  gl.DepthFunc(gl.EQUAL)
  pull()
end

return scene_depth
