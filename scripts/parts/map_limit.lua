-- What a map of `size` texels can tell, as a recipe's limit: a fragment may take its shadow from as far as its
-- filter reads across the light's rays, from where a caster's plane is pushed back and its own is taken for
-- nearer by as much of their slopes, and no nearer along them than what the map's depths are rounded by, and
-- offset for it. `maps` is a list of what has a projection: the coarsest counts.
--
-- A light within its casters' bounds has its near plane at 1e-5 of the far one (shadow.light_view). A caster's
-- triangle that passes the light is cut there, where 1 - near / z multiplies the rounding of z by thousands,
-- and that goes on over all of the triangle: such a map tells no depths at all. Nor is anything
-- claimed of one whose light is nearer to a caster than 1e-4 of the way to the farthest: the search found acne
-- between 2e-5 and that (seed 18, world 1917), and how sharp the bound is was not measured.
return function(maps, size, filter)
  local limit = { across = 0, light_units = 12, light_near = math.huge, light_range = 0 }
  for _, map in ipairs(maps) do
    local projection = map.projection
    local texel, depth = shadow.map_bias(projection, size).texel, projection:row(3)
    limit.across = math.max(limit.across, ((filter or 1) / 2 + 1) * math.sqrt(2) * texel)
    if projection:row(4).w == 0 then
      local near, far = depth.w / (depth.z - 1), depth.w / (depth.z + 1)
      limit.light_near = math.min(limit.light_near, near)
      if near < 1e-4 * far then limit.light_units = math.huge end
    else
      limit.light_near = 0
      limit.light_range = math.max(limit.light_range, -2 / depth.z)
    end
  end
  return limit
end
