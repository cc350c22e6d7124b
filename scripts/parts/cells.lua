-- A closed solid of box-shaped cells: `filled(i, j, k)` says which cells of the lattice whose planes are
-- at xs, ys, zs (ascending) are solid. A face is made wherever a solid cell meets none, so the surface
-- has no boundary, and every edge ends at corners of the lattice: there is no T-junction.
return function(xs, ys, zs, filled)
  local axes = { xs, ys, zs }
  local positions, indices = {}, {}

  local function solid(cell)
    for axis = 1, 3 do
      if cell[axis] < 1 or cell[axis] >= #axes[axis] then return false end
    end
    return filled(cell[1], cell[2], cell[3])
  end

  -- The face of a cell across `axis`, at its upper end (side 1) or its lower end (side 0).
  local function face(cell, axis, side)
    local across, up = axis % 3 + 1, (axis + 1) % 3 + 1
    local first = #positions
    for i, corner in ipairs{ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } } do
      local at = { table.unpack(cell) }
      at[axis] = at[axis] + side
      at[across] = at[across] + corner[1]
      at[up] = at[up] + corner[2]
      positions[first + i] = vec3(xs[at[1]], ys[at[2]], zs[at[3]])
    end
    local order = side == 1 and { 0, 1, 2, 0, 2, 3 } or { 0, 2, 1, 0, 3, 2 }
    for _, corner in ipairs(order) do indices[#indices + 1] = first + corner end
  end

  for i = 1, #xs - 1 do
    for j = 1, #ys - 1 do
      for k = 1, #zs - 1 do
        local cell = { i, j, k }
        if solid(cell) then
          for axis = 1, 3 do
            for side = 0, 1 do
              local neighbour = { i, j, k }
              neighbour[axis] = neighbour[axis] + 2 * side - 1
              if not solid(neighbour) then face(cell, axis, side) end
            end
          end
        end
      end
    end
  end
  return mesh.new{ positions = positions, indices = indices }
end
