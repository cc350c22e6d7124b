-- Requires by an absolute path.
-- expect: recipe error
-- says: letters
return {
  draw = function(r)
    require "/etc/passwd"
  end,
}
