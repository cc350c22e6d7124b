-- Never stops, in the comparison of a sort.
-- expect: recipe error
-- says: for more than
return {
  draw = function(r)
    table.sort({ 3, 2, 1 }, function() while true do end end)
  end,
}
