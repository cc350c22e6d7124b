-- A mesh whose indices are past its vertices.
-- expect: recipe error
return {
  draw = function(r)
    mesh.new { positions = { vec3(0, 0, 0) }, indices = { 0, 1, 2 } }
  end,
}
