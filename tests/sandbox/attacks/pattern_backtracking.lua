-- A pattern of 2^40 ways to fail.
-- expect: recipe error
-- says: for more than
-- script: 0.2 s
return {
  draw = function(r)
    return ("a"):rep(40):find(("a?"):rep(40) .. ("a"):rep(40))
  end,
}
