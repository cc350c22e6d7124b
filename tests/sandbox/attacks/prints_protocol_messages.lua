-- Prints messages of the grader's protocol.
-- expect: finished
return {
  draw = function(r)
    local message = "SLW1\3\0\0\0\0\0\0\0\0\0\0\0"
    for _ = 1, 1000 do print(message) end
  end,
}
