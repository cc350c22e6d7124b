-- Where things are in a picture, computed apart from what draws it.
local analytic = {}

-- What sees a frame: matrices and size. Pixels are those of a picture: (0, 0) at the lower left.
function analytic.viewer(camera, width, height)
  local viewer = { width = width, height = height }
  viewer.clip = camera:projection(width / height) * camera:view()
  viewer.world = viewer.clip:inverse()
  viewer.eye = camera.eye
  return viewer
end

-- Window coordinates of a point in front of the camera, in pixels, and its window depth.
function analytic.window(viewer, point)
  local p = viewer.clip * vec4(point, 1)
  return vec2((p.x / p.w + 1) / 2 * viewer.width, (p.y / p.w + 1) / 2 * viewer.height),
         (p.z / p.w + 1) / 2
end

-- The point of a plane (vec4) that the centre of a pixel shows; nil where its ray misses the plane.
function analytic.on_plane(viewer, plane, x, y)
  local far = viewer.world:transform_point(vec3((x + 0.5) / viewer.width * 2 - 1,
                                                (y + 0.5) / viewer.height * 2 - 1, 0.5))
  local a, b = plane:dot(vec4(viewer.eye, 1)), plane:dot(vec4(far, 1))
  local t = a / (a - b)
  if not (t > 0 and t < math.huge) then return nil end
  return viewer.eye + (far - viewer.eye) * t
end

-- Where the ray from the light (w = 1) through a point, or along it (w = 0), meets a plane.
function analytic.cast(plane, light, point)
  local along = light.w == 0 and -light.xyz or point - light.xyz
  local t = -plane:dot(vec4(point, 1)) / plane.xyz:dot(along)
  return point + along * t
end

-- The convex hull of vec2s, counter-clockwise (Andrew's monotone chain), with its sides: a, b, c with
-- a x + b y + c the distance from the side's line, positive inside.
function analytic.hull(points)
  table.sort(points, function(a, b) return a.x < b.x or (a.x == b.x and a.y < b.y) end)
  local hull = {}
  local function chain(first, last, step)
    local base = #hull
    for i = first, last, step do
      local p = points[i]
      while #hull >= base + 2 do
        local a, b = hull[#hull - 1], hull[#hull]
        if (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) > 0 then break end
        hull[#hull] = nil
      end
      hull[#hull + 1] = p
    end
    hull[#hull] = nil
  end
  chain(1, #points, 1)
  chain(#points, 1, -1)
  hull.sides = {}
  for i, p in ipairs(hull) do
    local q = hull[i % #hull + 1]
    local inward = vec2(p.y - q.y, q.x - p.x):normalize()
    hull.sides[i] = { inward.x, inward.y, -inward:dot(p) }
  end
  return hull
end

-- How deep a point is in a hull: the least distance from its sides' lines, negative outside.
function analytic.depth_inside(hull, x, y)
  local least = math.huge
  for _, side in ipairs(hull.sides) do
    local distance = side[1] * x + side[2] * y + side[3]
    if distance < least then least = distance end
  end
  return least
end

-- The hull, in the window, of points of the world in front of the camera.
function analytic.window_hull(viewer, points)
  local seen = {}
  for i, p in ipairs(points) do seen[i] = analytic.window(viewer, p) end
  return analytic.hull(seen)
end

-- "in" or "out" for the centre of a pixel that is a pixel or more from the hull's edge; else nil.
function analytic.side(hull, x, y)
  local depth = analytic.depth_inside(hull, x + 0.5, y + 0.5)
  return depth >= 1 and "in" or depth <= -1 and "out" or nil
end

-- The vertices of an object, world space.
function analytic.vertices(object)
  local points = {}
  for i = 0, object.mesh.vertices - 1 do
    points[i + 1] = object.model:transform_point(object.mesh:position(i))
  end
  return points
end

-- The 8-bit value of a colour's component, as GL rounds it (OpenGL 4.5, section 2.3.5.1).
function analytic.level(value)
  return math.floor(math.min(math.max(value, 0), 1) * 255 + 0.5)
end

-- A colour as the 8-bit levels of a pixel, and a pixel's.
function analytic.levels(color)
  return vec3(analytic.level(color.r), analytic.level(color.g), analytic.level(color.b))
end

function analytic.rgb(picture, x, y)
  return vec4(picture:color(x, y)).rgb
end

-- What shaders/phong.frag gives at a point of a receiver.
function analytic.phong(viewer, point, normal, light, color, ambient)
  local to_eye = (viewer.eye - point):normalize()
  local to_light = (light.xyz - point * light.w):normalize()
  local n = normal:dot(to_eye) < 0 and -normal or normal
  local diffuse = math.max(n:dot(to_light), 0)
  local highlight = diffuse > 0 and math.max(n:dot((to_light + to_eye):normalize()), 0) ^ 32 or 0
  return color * (ambient + (1 - ambient) * diffuse) + 0.2 * highlight
end

return analytic
