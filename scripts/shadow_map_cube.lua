-- A point light inside the scene: no frustum sees all around it, so that the map has six faces, one
-- for each half-axis, and is looked up by the direction from the light. Faces on which no caster can
-- shadow what is seen are neither made nor drawn; and while light and casters are still the map is kept.
local draw_lit = require "parts.draw_lit"
local map_array = require "parts.map_array"
local map_limit = require "parts.map_limit"
local still = require "parts.still"

local recipe = {
  title   = "A cube of shadow maps",
  lecture = "003_dcbdf1292070997a: Omnidirectional shadow maps",
  scene   = "room",
  truth   = "hard",
  params  = {
    light  = param.point(0.2, 2.1, 0.9),
    size   = param.integer(512, 16, 4096),     -- of each face
    filter = param.choice("NEAREST", "LINEAR"),
    keep   = param.toggle(true),               -- the map of a still light, for every camera
    cull   = param.toggle(true),               -- faces without a shadow that is seen
  },
  sweep   = { size = { 128, 256, 512, 1024, 2048 } },
}

-- A light at infinity shines one way: one map is enough for it.
function recipe.holds(r)
  return r.params.light.w > 0
end

local names = { "+x", "-x", "+y", "-y", "+z", "-z" }
local targets = {
  gl.TEXTURE_CUBE_MAP_POSITIVE_X, gl.TEXTURE_CUBE_MAP_NEGATIVE_X,
  gl.TEXTURE_CUBE_MAP_POSITIVE_Y, gl.TEXTURE_CUBE_MAP_NEGATIVE_Y,
  gl.TEXTURE_CUBE_MAP_POSITIVE_Z, gl.TEXTURE_CUBE_MAP_NEGATIVE_Z,
}

function recipe.limit(r)
  local near, far = shadow.cube_range(r.params.light, r.scene, { fit = r.params.keep and "scene" or "view" })
  return map_limit({ shadow.cube_faces(r.params.light, near, far)[1] }, r.params.size)
end

-- Of six faces that have one size: GL takes no cube without each.
local function make_cube(size, filter)
  local cube = gl.GenTextures(1)
  gl.BindTexture(gl.TEXTURE_CUBE_MAP, cube)
  for _, face in ipairs(targets) do
    gl.TexImage2D(face, 0, gl.DEPTH_COMPONENT24, size, size, 0, gl.DEPTH_COMPONENT, gl.FLOAT, nil)
  end
  gl.TexParameteri(gl.TEXTURE_CUBE_MAP, gl.TEXTURE_MIN_FILTER, gl[filter])
  gl.TexParameteri(gl.TEXTURE_CUBE_MAP, gl.TEXTURE_MAG_FILTER, gl[filter])
  gl.TexParameteri(gl.TEXTURE_CUBE_MAP, gl.TEXTURE_COMPARE_MODE, gl.COMPARE_REF_TO_TEXTURE)
  gl.TexParameteri(gl.TEXTURE_CUBE_MAP, gl.TEXTURE_COMPARE_FUNC, gl.LEQUAL)
  return cube
end

function recipe.setup(r)
  r.size, r.filter = r.params.size, r.params.filter
  r.depth = shader.load "flat"
  r.mapped = shader.load "shadow_map_cube"
  r.frames, r.shown = {}, {}
  r.fbo = gl.GenFramebuffers(1)
  gl.BindFramebuffer(gl.FRAMEBUFFER, r.fbo)
  gl.DrawBuffer(gl.NONE)
  gl.ReadBuffer(gl.NONE)
end

-- Where the faces are: in a cube, where all are read, or a filter goes from one to the next; else those that
-- are read alone, as layers of an array, by their numbers from 0, and -1 for the others.
local function places(r, faces, read)
  local count = 0
  for i, face in ipairs(faces) do
    face.read = read[i] or false
    if face.read then count = count + 1 end
  end
  if count == 6 or count > 0 and r.filter == "LINEAR" then
    r.cube = r.cube or make_cube(r.size, r.filter)
    return { -1, -1, -1, -1, -1, -1 }, r.cube
  end
  local layers = map_array.layers_of(r, r.size, faces)
  if r.layers then
    -- A face's rim goes on, as it does in a cube.
    gl.BindTexture(gl.TEXTURE_2D_ARRAY, r.layers)
    gl.TexParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE)
    gl.TexParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE)
  end
  return layers
end

local every = { true, true, true, true, true, true }

function recipe.draw(r)
  local scene, camera, light, size = r.scene, r.scene.camera, r.params.light, r.size
  local fit = { fit = r.params.keep and "scene" or "view" }
  local near, far = shadow.cube_range(light, scene, fit)
  local faces = shadow.cube_faces(light, near, far)
  local bias = shadow.map_bias(faces[1].projection, size, r.filter == "LINEAR" and 2 or 1)
  local read = not bias.read and {} or r.params.cull and shadow.faces_needed(light, scene, fit) or every
  local layers, cube = places(r, faces, read)
  local held = table.concat(layers, " ")
  if r.held ~= held then r.held, r.shown = held, {} end

  gl.Enable(gl.DEPTH_TEST)
  if bias.read and not (r.params.keep and still(r.shown, faces[1].projection * faces[1].view, scene.casters)) then
    gl.Viewport(0, 0, size, size)
    gl.Enable(gl.POLYGON_OFFSET_FILL)
    gl.PolygonOffset(bias.factor, bias.units)
    for i, face in ipairs(faces) do
      if cube or face.read then
        pass("1. face " .. names[i] .. (face.read and "" or ", cleared: no shadow there is seen"), function()
          gl.BindFramebuffer(gl.FRAMEBUFFER, cube and r.fbo or r.frames[layers[i] + 1])
          if cube then
            gl.FramebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, targets[i], cube, 0)
          end
          gl.Clear(gl.DEPTH_BUFFER_BIT)
          if face.read then
            scene.caster:draw(r.depth, { view = face.view, projection = face.projection })
          end
        end)
      end
    end
    gl.Disable(gl.POLYGON_OFFSET_FILL)
    gl.BindFramebuffer(gl.FRAMEBUFFER, 0)
    gl.Viewport(0, 0, r.width, r.height)
  end

  pass("2. the scene, by direction", function()
    local view, projection = camera:view(), camera:projection(r.width / r.height)
    gl.ClearColor(0.85, 0.88, 0.92, 1)
    gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
    gl.Enable(gl.TEXTURE_CUBE_MAP_SEAMLESS)   -- a filter at a face's edge reads the next face
    if cube then gl.BindTexture(gl.TEXTURE_CUBE_MAP, cube) end
    gl.ActiveTexture(gl.TEXTURE1)
    if r.layers then gl.BindTexture(gl.TEXTURE_2D_ARRAY, r.layers) end
    draw_lit(scene, r.mapped, {
      view = view, projection = projection, light = light, near = near, far = far,
      shadow_map = 0, shadow_maps = 1, layers = layers, in_cube = cube ~= nil,
      reach = 2 * bias.reach,   -- a face is two wide at distance 1
      light_matrix = mat4.translate(-light.xyz / light.w) * view:inverse(),
    })
  end)
end

return recipe
