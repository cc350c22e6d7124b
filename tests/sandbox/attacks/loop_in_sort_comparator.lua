-- Never stops, in the comparison of a sort.
-- expect: recipe error
-- says: for more than
-- script: 0.2 s
return {
  draw = function(r)
    table.sort({ 3, 2, 1 }, function() while true do end end)
  end,
}
