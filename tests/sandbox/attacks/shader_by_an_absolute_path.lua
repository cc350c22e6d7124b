-- Loads a shader by an absolute path.
-- expect: recipe error
return {
  draw = function(r)
    shader.load "/etc/passwd"
  end,
}
