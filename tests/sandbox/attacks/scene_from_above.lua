-- Loads a scene from above its folder.
-- expect: recipe error
return {
  draw = function(r)
    scene.load "../../etc/passwd"
  end,
}
