-- Casters in groups that 7 bits can count: the sum of their layers (how often a volume may hold one
-- point) is at most 127. A caster that has more by itself is drawn in parts. Each group is a list of
-- { caster = , part = }, as shadow.volume takes them.
return function(casters, light)
  local batches, layers, all = { {} }, 0, 0
  for _, caster in ipairs(casters) do
    for part, own in ipairs(shadow.parts(caster, nil, light)) do
      if layers > 0 and layers + own > 127 then
        table.insert(batches, {})
        layers = 0
      end
      table.insert(batches[#batches], { caster = caster, part = part })
      layers = layers + own
      all = all + own
    end
  end
  local function counted(count, what) return count .. " " .. what .. (count == 1 and "" or "s") end
  explain(counted(#casters, "caster") .. " in " .. counted(#batches, "group") ..
          ": their volumes may hold a point " .. all .. " times, and 7 bits of stencil count to 127.")
  return batches
end
