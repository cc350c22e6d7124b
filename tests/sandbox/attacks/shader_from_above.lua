-- Loads a shader from above its folder.
-- expect: recipe error
return {
  draw = function(r)
    shader.load "../../../../../etc/passwd"
  end,
}
