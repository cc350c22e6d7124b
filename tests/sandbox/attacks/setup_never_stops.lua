-- Never stops in setup.
-- expect: recipe error
-- says: for more than
-- script: 0.2 s
return { setup = function() while true do end end, draw = function() end }
