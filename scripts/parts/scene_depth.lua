-- The scene in the depth buffer, as shadow volumes are counted against it. Depth does not say exactly
-- which of two surfaces is in front: it is rounded to 24 bits, by 1/2 unit and again where the other is;
-- and since corners are moved to 1/256 of a pixel, a pixel of a face may lie 1/512 of a pixel beyond it,
-- where the face's slope takes its depth. So what is seen is pulled toward the eye by that error of its
-- own, and the volumes are pushed back by theirs (parts.own_shadow):
--  - no lit face stands in the sides of its own volume, which run close along it near the terminator;
--  - the cap in the plane that a caster stands on is behind that plane.
-- A box's sides that are turned from the eye are not drawn: by that rounding they would win a pixel of its
-- outline here and there.
-- Square to the view a shadow begins late by that: 2 z^2 / (near 2^24) metres at a distance of z.
local scene_depth = {}

local function pull()
  gl.Enable(gl.POLYGON_OFFSET_FILL)
  gl.PolygonOffset(-1 / 512, -2)
end

-- Draws each object, and of those in `fronts` no side that is turned from the eye.
local function draw_all(objects, fronts, shader, uniforms)
  for _, object in ipairs(objects) do
    if not fronts[object] then object:draw(shader, uniforms) end
  end
  gl.Enable(gl.CULL_FACE)
  for _, object in ipairs(objects) do
    if fronts[object] then object:draw(shader, uniforms) end
  end
  gl.Disable(gl.CULL_FACE)
end

-- Leaves 1 in the stencil where a caster is seen. A caster that touches a receiver which hides it could
-- still win a pixel there, by a side that is turned from the light: so who is seen is decided first, with
-- the casters pushed back. As far as the caps of their volumes are: what hides a caster hides its cap.
-- Returns the set of the objects that hide their back, for draw_again.
function scene_depth.draw(objects, shader, seen)
  local fronts, receivers, casters = {}, {}, {}
  for _, object in ipairs(objects) do
    fronts[object] = shadow.hides_its_back(object, seen.view, seen.projection)
    table.insert(object.role == "receiver" and receivers or casters, object)
  end
  pull()
  draw_all(receivers, fronts, shader, seen)
  gl.Enable(gl.STENCIL_TEST)
  gl.StencilFunc(gl.ALWAYS, 1, 0xFF)
  gl.StencilOp(gl.KEEP, gl.KEEP, gl.REPLACE)
  gl.PolygonOffset(1 / 512, 0)
  draw_all(casters, fronts, shader, seen)
  gl.StencilFunc(gl.EQUAL, 1, 0xFF)
  gl.StencilOp(gl.KEEP, gl.KEEP, gl.KEEP)
  pull()
  draw_all(casters, fronts, shader, seen)
  return fronts
end

-- What is drawn from now on, by a shader that places corners alike, meets its own depths again.
function scene_depth.match()
  gl.DepthFunc(gl.EQUAL)
  pull()
end

-- Draws some of the objects whose depths are there, `fronts` being what scene_depth.draw returned.
scene_depth.draw_again = draw_all

-- What that costs, as a recipe's limit: the two steps of the pull, and for either depth up to five. Two of those
-- are roundings, of the window's depth and of interpolating it. Three are of floats: depth is the difference of
-- clip space's w and z, each of which is a sum rounded to some 2^-22 of it, over w. So a shadow begins late by at
-- most 12 z^2 / (near 2^24), and a caster's foot may be cut off by that. (The search has found 8.8 steps.) Of two
-- sides of volumes that are so near one may be counted and the other not.
function scene_depth.limit() return { eye_units = 12 } end

return scene_depth
