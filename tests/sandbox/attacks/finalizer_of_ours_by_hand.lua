-- Calls a finalizer of ours twice, and on another type.
-- expect: recipe error
return {
  draw = function(r)
    local gc = getmetatable(vec3(1, 2, 3)).__gc
    gc(mat4.translate(0, 0, 0))
    gc(mat4.translate(0, 0, 0))
  end,
}
