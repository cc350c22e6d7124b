-- Fails with a message of 16 MiB.
-- expect: recipe error
return {
  draw = function(r)
    error(("x"):rep(1 << 24))
  end,
}
