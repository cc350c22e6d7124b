-- A light with a size: a sphere, a square or a disk of `radius` (of a square: half its side) around the
-- point `light`. The flat ones are parallel to the ground.
return function(light, shape, radius)
  if radius == 0 then return light end
  if shape == "sphere" then return { center = light.xyz, radius = radius } end
  return { center = light.xyz, u = vec3(radius, 0, 0), v = vec3(0, 0, radius), disk = shape == "disk" }
end
