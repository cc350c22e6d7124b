-- Never stops, when a variable goes out of scope.
-- expect: recipe error
-- says: for more than
-- script: 0.2 s
return {
  draw = function(r)
    local m = {}
    local t = setmetatable({}, m)
    m.__close = function() while true do end end
    do local x <close> = t end
  end,
}
