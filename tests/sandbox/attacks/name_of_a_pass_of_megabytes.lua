-- A pass whose name has 16 MiB.
-- expect: recipe error or finished
return {
  draw = function(r)
    pass(("x"):rep(1 << 24), function() end)
  end,
}
