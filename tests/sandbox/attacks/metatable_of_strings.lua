-- Changes what all strings do.
-- expect: recipe error
return {
  draw = function(r)
    getmetatable("").__index = function() return "owned" end
  end,
}
