-- Runs another file.
-- expect: recipe error
-- says: dofile
return {
  draw = function(r)
    dofile("/etc/passwd")
  end,
}
