-- Values of ours until memory ends.
-- expect: recipe error
-- says: memory
-- memory: 16 MiB
return {
  draw = function(r)
    local t = {}
    for i = 1, 1e9 do t[i] = mat4.translate(i, 0, 0) end
  end,
}
