-- Meshes until memory ends.
-- expect: recipe error
return {
  draw = function(r)
    local t = {}
    for i = 1, 1e9 do t[i] = mesh.sphere(1, 200, 200) end
  end,
}
