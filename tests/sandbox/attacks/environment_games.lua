-- Changes the environment that native code sees.
-- expect: recipe error or finished
return {
  draw = function(r)
    local _ENV = setmetatable({}, { __index = function(_, k) return _G and _G[k] end })
    gl.Clear(1)
  end,
}
