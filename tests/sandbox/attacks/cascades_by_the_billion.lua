-- A billion cascades.
-- expect: recipe error
return {
  draw = function(r)
    shadow.cascades(scene.load("table").camera, vec4(0, 1, 0, 0), 1000000000, {})
  end,
}
