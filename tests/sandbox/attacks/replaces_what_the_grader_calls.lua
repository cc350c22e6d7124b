-- Replaces pass, gl and require.
-- expect: finished or recipe error
return {
  draw = function(r)
    pass = function() end
    require = function() return {} end
    print = error
    local ok = pcall(function() gl.Clear = function() end end)
    assert(not ok)
  end,
}
