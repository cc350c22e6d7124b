-- A million coroutines that wait.
-- expect: recipe error
return {
  draw = function(r)
    local t = {}
    for i = 1, 1e6 do t[i] = coroutine.create(function() coroutine.yield() end) coroutine.resume(t[i]) end
  end,
}
