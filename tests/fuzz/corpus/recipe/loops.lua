local t = setmetatable({}, { __index = function(_, k) return k end, __close = function() end })
for i = 1, 10 do t[i] = ("x"):rep(i):gsub("x+", "%0%0") end
local ok, why = pcall(string.format, "%5.2f %s %q", 1.5, t, "a")
local co = coroutine.wrap(function(...) for _, v in ipairs{...} do coroutine.yield(v) end end)
goto done
::done:: print(ok, why, co(1, 2), #t, ~5 // 2, 3 << 4, table.unpack({ 1, 2 }), select("#", nil, nil))
