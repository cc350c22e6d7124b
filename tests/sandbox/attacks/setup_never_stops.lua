-- Never stops in setup.
-- expect: recipe error
-- says: for more than
return { setup = function() while true do end end, draw = function() end }
