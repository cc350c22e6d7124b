-- A billion samples of a light.
-- expect: recipe error
return {
  draw = function(r)
    shadow.samples({ center = vec3(0, 3, 0), radius = 0.2 }, 1000000000)
  end,
}
