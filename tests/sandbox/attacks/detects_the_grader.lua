-- Looks for what tells that it is graded.
-- expect: finished or recipe error
return {
  draw = function(r)
    assert(not rawget(_G, "os") and not rawget(_G, "io") and not rawget(_G, "arg"))
    if r.width == 16 and r.time == 0 then gl.ClearColor(1, 1, 1, 1) end
    gl.Clear(gl.COLOR_BUFFER_BIT)
  end,
}
