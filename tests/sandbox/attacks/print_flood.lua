-- Prints for ever.
-- expect: recipe error
-- says: for more than
return {
  draw = function(r)
    while true do print(("x"):rep(10000)) end
  end,
}
