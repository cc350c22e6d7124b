-- Calls a method of a mesh on a shader and on a number.
-- expect: recipe error
return {
  draw = function(r)
    local draw = mesh.quad().draw
    draw(vec3(1, 2, 3))
  end,
}
