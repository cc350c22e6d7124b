-- Calls itself for ever.
-- expect: recipe error
-- says: recursion
return {
  draw = function(r)
    local function f() return 1 + f() end
    f()
  end,
}
