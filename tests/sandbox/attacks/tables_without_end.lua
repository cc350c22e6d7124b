-- Tables until memory ends.
-- expect: recipe error
-- says: memory
-- memory: 16 MiB
return {
  draw = function(r)
    local t = {}
    while true do t = { t, {}, {}, {} } end
  end,
}
