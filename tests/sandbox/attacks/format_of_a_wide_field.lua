-- A field 99,999,999 wide.
-- expect: recipe error
return {
  draw = function(r)
    string.format("%99999999d", 1)
  end,
}
