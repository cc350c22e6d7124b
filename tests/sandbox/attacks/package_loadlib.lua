-- Loads a library.
-- expect: recipe error
-- says: package
return {
  draw = function(r)
    package.loadlib("/lib/x86_64-linux-gnu/libc.so.6", "system")
  end,
}
