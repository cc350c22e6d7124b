-- Spreads a string on the stack.
-- expect: recipe error
return {
  draw = function(r)
    print((("x"):rep(1 << 23)):byte(1, -1))
  end,
}
