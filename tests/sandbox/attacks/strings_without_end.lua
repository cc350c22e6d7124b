-- Strings until memory ends.
-- expect: recipe error
-- says: memory
-- memory: 16 MiB
return {
  draw = function(r)
    local s = "x"
    while true do s = s .. s end
  end,
}
