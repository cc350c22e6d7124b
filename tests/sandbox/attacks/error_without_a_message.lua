-- Fails with nothing.
-- expect: recipe error
-- says: without a message
return {
  draw = function(r)
    error(nil)
  end,
}
