-- The projection onto a plane P = (a, b, c, d) in its forms: from the origin, from a point, along a
-- direction, and from the general light L = (x, y, z, w), of which the others are cases:
--
--   M = (P·L) I - L Pᵀ      L = (0, 0, 0, 1), (x, y, z, 1), (x, y, z, 0), (x, y, z, w)
--
-- "z = 0" is P = L = (0, 0, 1, 0): M keeps x and y, and each vertex lands at (x, y, 0). A cube, its
-- flattened image, a ball at each vertex and at its image, and the line of projection between them;
-- the axes are x red, y green, z blue, the light is yellow. --set print=true prints the matrix.
--
-- M is of homogeneous coordinates: its images have a w that is not 1, and only x/w, y/w, z/w are
-- points. The slides leave the plane's sign to the reader; with P·L < 0 each w is negative, and GL clips
-- the whole shadow away. shadow.planar chooses the sign.
local recipe = {
  title   = "Projection onto a plane, in its four forms",
  lecture = "000_178f3ee06912f876: Projecció respecte l'origen, un punt, una direcció; "
         .. "004_502e9deeb91da7bb: Projection centrale, z = 0",
  scene   = "cube",
  params  = {
    form  = param.choice("light", "origin", "point", "direction", "z = 0"),
    point = param.point(1, 1.25, 0.5),
    w     = param.number(0.8, 0, 1),      -- of the general light: 1 a point, 0 a direction
    print = param.toggle(false),
  },
  keys    = { f = "next form", w = "toggle w 0 0.8" },
}

-- The floor is below the origin, since a light in the plane throws no shadow on it.
local floor, wall = vec4(0, 1, 0, 1.5), vec4(0, 0, 1, 0)

-- The plane, the light and the matrix of a form.
local function form_of(r)
  local form, p = r.params.form, r.params.point
  if form == "origin" then
    return floor, vec4(0, 0, 0, 1), shadow.planar_from_origin(floor)
  elseif form == "point" then
    return floor, p, shadow.planar_from_point(floor, p.xyz)
  elseif form == "direction" then
    return floor, vec4(p.xyz, 0), shadow.planar_along(floor, p.xyz)
  elseif form == "z = 0" then
    return wall, vec4(0, 0, 1, 0), shadow.planar(wall, vec4(0, 0, 1, 0))
  end
  local light = vec4(p.xyz, r.params.w)
  return floor, light, shadow.planar(floor, light)
end

function recipe.setup(r)
  r.phong = shader.load "phong"
  r.flat = shader.load "flat"
  r.ball = mesh.sphere(1, 24, 12)
  r.rod = mesh.box(1, 1, 1)
  r.tile = mesh.plane(0.98, 0.98)
end

-- A rod from a to b.
local function draw_line(r, camera, a, b, thickness, color)
  local along = b - a
  local length = along:length()
  if length == 0 then return end
  local y = along / length
  local x = y:cross(math.abs(y.y) < 0.9 and vec3(0, 1, 0) or vec3(1, 0, 0)):normalize()
  local model = mat4(vec4(x * thickness, 0), vec4(along, 0), vec4(x:cross(y) * thickness, 0),
                     vec4((a + b) / 2, 1))
  r.rod:draw(r.flat, { view = camera.view, projection = camera.projection, model = model,
                       color = color })
end

local function draw_ball(r, camera, at, radius, color)
  r.ball:draw(r.flat, { view = camera.view, projection = camera.projection, color = color,
                        model = mat4.translate(at) * mat4.scale(radius) })
end

function recipe.draw(r)
  local plane, light, onto_plane = form_of(r)
  if r.params.print then print(onto_plane) end
  local cube = r.scene.casters[1]
  local camera = { view = r.scene.camera:view(),
                   projection = r.scene.camera:projection(r.width / r.height) }
  -- The direction to a light at infinity, or the light's place.
  local at = light.w ~= 0 and light.xyz / light.w
  local lamp = at and vec4(at, 1) or vec4(light.xyz, 0)

  gl.ClearColor(0.95, 0.95, 0.93, 1)
  gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
  gl.Enable(gl.DEPTH_TEST)

  pass("1. the plane and the axes", function()
    local tilt = plane == wall and mat4.rotate(90, 1, 0, 0) or mat4.translate(0, -plane.w, 0)
    for x = -2, 2 do
      for z = -2, 2 do
        local shade = (x + z) % 2 == 0 and 0.80 or 0.86
        r.tile:draw(r.flat, { view = camera.view, projection = camera.projection,
                              color = vec3(shade), model = tilt * mat4.translate(x, 0, z) })
      end
    end
    draw_line(r, camera, vec3(0), vec3(1, 0, 0), 0.03, vec3(0.85, 0.15, 0.15))
    draw_line(r, camera, vec3(0), vec3(0, 1, 0), 0.03, vec3(0.15, 0.60, 0.15))
    draw_line(r, camera, vec3(0), vec3(0, 0, 1), 0.03, vec3(0.15, 0.25, 0.85))
  end)

  pass("2. the projected cube", function()
    gl.Enable(gl.POLYGON_OFFSET_FILL)
    gl.PolygonOffset(-1, -1)
    cube:draw(r.flat, { view = camera.view, projection = camera.projection,
                        model = onto_plane * cube.model, color = vec3(0.32, 0.32, 0.36) })
    gl.Disable(gl.POLYGON_OFFSET_FILL)
  end)

  pass("3. the cube and the light", function()
    cube:draw(r.phong, { view = camera.view, projection = camera.projection, light = lamp,
                         ambient = 0.4 })
    if at then draw_ball(r, camera, at, 0.09, vec3(1.0, 0.80, 0.10)) end
  end)

  pass("4. the vertices, their images and the lines between", function()
    for corner = 0, 7 do
      local low, high = cube.mesh.low, cube.mesh.high
      local v = cube.model:transform_point(vec3(corner & 1 == 0 and low.x or high.x,
                                                corner & 2 == 0 and low.y or high.y,
                                                corner & 4 == 0 and low.z or high.z))
      local image = onto_plane:transform_point(v)
      -- From the light; from afar where it has no place.
      local from = at or v + light.xyz:normalize() * 1.2
      draw_line(r, camera, from, image, 0.012, vec3(0.95, 0.66, 0.10))
      draw_ball(r, camera, v, 0.035, vec3(0.55, 0.25, 0.05))
      draw_ball(r, camera, image, 0.035, vec3(0.76, 0.10, 0.36))
    end
  end)
end

return recipe
