-- Reads a text of ours as a mesh, to have it quoted.
-- expect: recipe error
return {
  draw = function(r)
    mesh.obj "room.lua"
  end,
}
