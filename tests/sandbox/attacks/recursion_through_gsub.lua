-- Calls itself for ever through native code.
-- expect: recipe error
return {
  draw = function(r)
    local function f() return (("x"):gsub("x", f)) end
    f()
  end,
}
