-- Requires the solution.
-- expect: recipe error
-- says: there is no
return {
  draw = function(r)
    require "solution"
  end,
}
