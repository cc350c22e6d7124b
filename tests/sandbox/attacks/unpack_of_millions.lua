-- Spreads 1e8 values on the stack.
-- expect: recipe error
return {
  draw = function(r)
    print(table.unpack({}, 1, 100000000))
  end,
}
