-- The lab's drawScene: a room's walls, each with the shadows that a light at a point throws on it,
-- clipped to it by the stencil, then the casters and the light. Recipe room has every switch of it.
local hard_room = {}

function hard_room.setup(r)
  r.gouraud = shader.load "gouraud"
  r.planar = shader.load "planar"
  r.orb = shader.load "orb"
  r.sphere = mesh.sphere(0.04, 24, 12)
end

-- Into a frame whose colour and depth the caller has cleared.
function hard_room.draw(r, light, darkness)
  local scene, camera = r.scene, r.scene.camera
  local view, projection = camera:view(), camera:projection(r.width / r.height)
  gl.Enable(gl.DEPTH_TEST)
  for _, wall in ipairs(scene.receivers) do
    gl.Clear(gl.STENCIL_BUFFER_BIT)
    gl.Enable(gl.STENCIL_TEST)
    gl.StencilFunc(gl.ALWAYS, 1, 0xFF)
    gl.StencilOp(gl.KEEP, gl.KEEP, gl.REPLACE)
    wall:draw(r.gouraud, { view = view, projection = projection, light = light, ambient = darkness })

    gl.StencilFunc(gl.EQUAL, 1, 0xFF)
    gl.Disable(gl.DEPTH_TEST)
    local onto_wall = shadow.planar(wall.plane, light)
    for _, caster in ipairs(scene.casters) do
      caster:draw(r.planar, { view = view, projection = projection, color = wall.color * darkness,
                              model = onto_wall * caster.model })
    end
    gl.Enable(gl.DEPTH_TEST)
    gl.Disable(gl.STENCIL_TEST)
  end
  scene.caster:draw(r.gouraud, { view = view, projection = projection, light = light, ambient = darkness })
  r.sphere:draw(r.orb, { view = view, projection = projection, color = vec3(1, 0.95, 0.7),
                         model = mat4.translate(light.xyz) })
end

return hard_room
