-- Requires what is above its folder.
-- expect: recipe error
-- says: letters
return {
  draw = function(r)
    require "../secret"
  end,
}
