-- Whether a map would show what it showed last time: the same casters in the same places, under the same
-- matrix. `last` is a table that remembers, the map's own; it is brought up to date.
return function(last, matrix, casters)
  local same = last.matrix == matrix and #last == #casters
  last.matrix = matrix
  for i = 1, math.max(#last, #casters) do
    local model = casters[i] and casters[i].model
    if last[i] ~= model then last[i], same = model, false end
  end
  return same
end
