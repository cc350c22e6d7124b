local recipe = { title = "a", params = {} }
function recipe.draw(r) local x <close> = nil return string.pack("<i4", #r), utf8.char(228), math.random(3) end
assert(load("return 1 + 1"))() error(setmetatable({}, { __tostring = function() return "e" end }))
return recipe
