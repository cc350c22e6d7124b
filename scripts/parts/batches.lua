-- Casters in groups that 7 bits can count: the sum of their layers (how often a volume may hold one
-- point) is at most 127. A caster with more is alone in its group.
return function(casters)
  local batches, layers, all = { {} }, 0, 0
  for _, caster in ipairs(casters) do
    local own = shadow.layers(caster)
    all = all + own
    own = math.min(own, 127)
    if layers + own > 127 and #batches[#batches] > 0 then
      table.insert(batches, {})
      layers = 0
    end
    table.insert(batches[#batches], caster)
    layers = layers + own
  end
  local function counted(count, what) return count .. " " .. what .. (count == 1 and "" or "s") end
  explain(counted(#casters, "caster") .. " in " .. counted(#batches, "group") ..
          ": their volumes may hold a point " .. all .. " times, and 7 bits of stencil count to 127.")
  return batches
end
