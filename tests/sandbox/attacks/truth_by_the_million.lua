-- A million samples of the exact shadow.
-- expect: recipe error or timed out
-- job: 1.5 s
return {
  draw = function(r)
    local s = scene.load("table")
    shadow.truth(s, s.camera, { center = vec3(0, 3, 0), radius = 0.2 }, { samples = 1000000 })
  end,
}
