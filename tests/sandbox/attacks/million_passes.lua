-- A million passes.
-- expect: recipe error
-- says: passes
return {
  draw = function(r)
    for i = 1, 1000000 do pass("pass " .. i, function() end) end
  end,
}
