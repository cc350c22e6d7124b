-- Prints for ever.
-- expect: recipe error
-- says: for more than
-- script: 0.2 s
return {
  draw = function(r)
    while true do print(("x"):rep(10000)) end
  end,
}
