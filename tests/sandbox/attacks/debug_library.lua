-- Looks for debug.
-- expect: recipe error
-- says: debug
return {
  draw = function(r)
    debug.getregistry()
  end,
}
