-- Passes within passes.
-- expect: recipe error
-- says: inside
return {
  draw = function(r)
    local function f() pass("again", f) end
    f()
  end,
}
