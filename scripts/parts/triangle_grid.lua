-- The casters' triangles as the light sees them, sorted into the cells of a grid over its map: what a
-- map stores in a texel is then not one depth but every triangle that a point of the texel can be
-- shadowed by, and each point is tested against those exactly.
local triangle_grid = {}

-- What of a polygon in clip space is before the light: w of `least` and more.
local function before_light(polygon, least)
  local kept = {}
  for i, p in ipairs(polygon) do
    local q = polygon[i % #polygon + 1]
    if p.w >= least then kept[#kept + 1] = p end
    if (p.w >= least) ~= (q.w >= least) then
      kept[#kept + 1] = p + (q - p) * ((least - p.w) / (q.w - p.w))
    end
  end
  return kept
end

-- Calls visit(a, b, c) for each triangle of the casters, in texture space: s and t in [0, 1] over the map,
-- p the depth, which is affine in them.
local function each_triangle(casters, to_texture, least, visit)
  for _, caster in ipairs(casters) do
    local m, matrix, corners = caster.mesh, to_texture * caster.model, {}
    for i = 0, m.vertices - 1 do corners[i] = matrix * vec4(m:position(i), 1) end
    for t = 0, m.triangles - 1 do
      local i, j, k = m:triangle(t)
      local a, b, c = corners[i], corners[j], corners[k]
      local polygon = { a, b, c }
      if a.w < least or b.w < least or c.w < least then polygon = before_light(polygon, least) end
      for n = 3, #polygon do
        local p, q, r = polygon[1], polygon[n - 1], polygon[n]
        visit(p.xyz / p.w, q.xyz / q.w, r.xyz / r.w)
      end
    end
  end
end

-- The cell of a coordinate, 0 to cells - 1.
local function cell_of(x, cells)
  return math.max(0, math.min(cells - 1, math.floor(x * cells)))
end

-- Whether the square cell around (x, y), half a cell `half` wide, is all on the outer side of an edge.
local function beyond(ax, ay, bx, by, turn, x, y, half)
  local nx, ny = (ay - by) * turn, (bx - ax) * turn
  return nx * (x - ax) + ny * (y - ay) + half * (math.abs(nx) + math.abs(ny)) < 0
end

-- triangles: 12 numbers each (three texels of four: s0 t0 s1 t1 | s2 t2 dp/ds dp/dt | p0, tolerance, 0, 0);
-- starts and counts by cell, and the list of triangles that they point into.
function triangle_grid.build(casters, to_texture, least, cells)
  local triangles, lists, half = {}, {}, 0.5 / cells * 1.001
  for i = 1, cells * cells do lists[i] = {} end
  local count = 0
  each_triangle(casters, to_texture, least, function(a, b, c)
    local area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)
    if area == 0 then return end          -- edge on, it hides nothing
    local along_s = ((b.z - a.z) * (c.y - a.y) - (c.z - a.z) * (b.y - a.y)) / area
    local along_t = ((c.z - a.z) * (b.x - a.x) - (b.z - a.z) * (c.x - a.x)) / area
    -- A point of the triangle's own plane is not beyond it, whatever floats make of its depth
    -- (2e-6) and of its place on the map, which a steep plane turns into depth (1e-5 of the map's side).
    local tolerance = 2e-6 + 1e-5 * (math.abs(along_s) + math.abs(along_t))
    local turn = area > 0 and 1 or -1
    local low_x, high_x = math.min(a.x, b.x, c.x), math.max(a.x, b.x, c.x)
    local low_y, high_y = math.min(a.y, b.y, c.y), math.max(a.y, b.y, c.y)
    if high_x < 0 or low_x > 1 or high_y < 0 or low_y > 1 then return end
    local n = #triangles
    triangles[n + 1], triangles[n + 2], triangles[n + 3], triangles[n + 4] = a.x, a.y, b.x, b.y
    triangles[n + 5], triangles[n + 6], triangles[n + 7], triangles[n + 8] = c.x, c.y, along_s, along_t
    triangles[n + 9], triangles[n + 10], triangles[n + 11], triangles[n + 12] = a.z, tolerance, 0, 0
    for j = cell_of(low_y, cells), cell_of(high_y, cells) do
      for i = cell_of(low_x, cells), cell_of(high_x, cells) do
        local x, y = (i + 0.5) / cells, (j + 0.5) / cells
        if not (beyond(a.x, a.y, b.x, b.y, turn, x, y, half) or beyond(b.x, b.y, c.x, c.y, turn, x, y, half)
                or beyond(c.x, c.y, a.x, a.y, turn, x, y, half)) then
          local list = lists[j * cells + i + 1]
          list[#list + 1] = count
        end
      end
    end
    count = count + 1
  end)
  local ranges, all, longest = {}, {}, 0
  for i, list in ipairs(lists) do
    ranges[2 * i - 1], ranges[2 * i] = #all, #list
    longest = math.max(longest, #list)
    for _, triangle in ipairs(list) do all[#all + 1] = triangle end
  end
  return { triangles = triangles, ranges = ranges, list = all, count = count, longest = longest }
end

-- A texture of floats, `width` texels a row, the last row filled up with zeros.
function triangle_grid.upload(unit, texture, internal, format, numbers, components, width)
  local row = width * components
  while #numbers == 0 or #numbers % row ~= 0 do numbers[#numbers + 1] = 0 end
  gl.ActiveTexture(unit)
  gl.BindTexture(gl.TEXTURE_2D, texture)
  gl.TexImage2D(gl.TEXTURE_2D, 0, internal, width, #numbers // row, 0, format, gl.FLOAT, numbers)
  gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST)
  gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST)
end

return triangle_grid
