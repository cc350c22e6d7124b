-- Its table never stops when it is read.
-- expect: recipe error
-- says: for more than
-- script: 0.2 s
return setmetatable({ draw = function() end }, { __index = function() while true do end end })
