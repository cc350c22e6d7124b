-- Strings until memory ends.
-- expect: recipe error
-- says: memory
return {
  draw = function(r)
    local s = "x"
    while true do s = s .. s end
  end,
}
