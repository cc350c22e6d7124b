-- Never stops, in a coroutine in a coroutine in …
-- expect: recipe error
-- says: for more than
-- script: 0.2 s
return {
  draw = function(r)
    local function f() coroutine.wrap(f)() end
    while true do pcall(f) end
  end,
}
