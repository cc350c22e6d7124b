-- The scene table, all of it moved by `offset` (vec3).
return function(offset)
  local world = require "scenes.table"
  local camera = {}
  for name, value in pairs(world.camera) do camera[name] = value end
  camera.eye, camera.target = camera.eye + offset, camera.target + offset
  local objects = {}
  for i, object in ipairs(world.objects) do
    objects[i] = { name = object.name, role = object.role, mesh = object.mesh, color = object.color,
                   model = mat4.translate(offset) * (object.model or mat4.identity()) }
  end
  return { title = world.title, camera = camera, objects = objects }
end
