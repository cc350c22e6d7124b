-- Casters in groups that 7 bits can count: the sum of their layers (how often a volume may hold one
-- point) is at most 127. A caster with more is alone in its group.
return function(casters)
  local batches, layers = { {} }, 0
  for _, caster in ipairs(casters) do
    local own = math.min(shadow.layers(caster), 127)
    if layers + own > 127 and #batches[#batches] > 0 then
      table.insert(batches, {})
      layers = 0
    end
    table.insert(batches[#batches], caster)
    layers = layers + own
  end
  return batches
end
