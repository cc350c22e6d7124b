-- Fails with a message that clears a terminal.
-- expect: recipe error
-- says: done
return {
  draw = function(r)
    error("\27[2J\27]0;owned\7done")
  end,
}
