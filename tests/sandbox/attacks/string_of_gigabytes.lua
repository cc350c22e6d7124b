-- A string of 8 GiB.
-- expect: recipe error
-- says: memory
return {
  draw = function(r)
    local s = ("x"):rep(1 << 33)
  end,
}
