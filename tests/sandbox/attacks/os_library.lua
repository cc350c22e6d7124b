-- Runs a program by os.
-- expect: recipe error
-- says: os
return {
  draw = function(r)
    os.execute("touch /tmp/owned")
  end,
}
