-- Its table never stops when it is read.
-- expect: recipe error or finished
return setmetatable({ draw = function() end }, { __index = function() while true do end end })
