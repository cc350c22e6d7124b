-- Reads a file by io.
-- expect: recipe error
-- says: io
return {
  draw = function(r)
    io.open("/etc/passwd"):read("a")
  end,
}
