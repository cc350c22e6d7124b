-- Reads a file of the system as a mesh.
-- expect: recipe error
return {
  draw = function(r)
    mesh.obj "/etc/passwd"
  end,
}
