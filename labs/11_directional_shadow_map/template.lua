-- Lab 11. The framebuffer and its texture are made, and the scene is drawn, lit everywhere. The sun's camera, the
-- depth pass and the shader are yours: fill in what is marked TO DO. README.md has the theory.
local recipe = {
  title   = "Lab 11: a shadow map of the sun",
  lecture = "001_863ae27a0c0eacfb: El mapeig d'ombres, exercici pràctic",
  scene   = "table",
  truth   = "hard",
  params  = {
    light    = param.direction(0.7, 1.2, 0.4),   -- toward the sun
    size     = param.integer(1024, 16, 4096),    -- of the map
    darkness = param.number(0.25, 0, 1),
  },
}

local vertex = [[
#version 330 core
// shadow_coord = light_matrix * the vertex in eye space: the sun's clip space.
#include "shadow_coordinate.glsl"
]]

local fragment = [[
#version 330 core
#include "lighting.glsl"
in vec4 shadow_coord;
uniform sampler2D shadow_map;

float shadow_calculation(vec4 coord) {
  // TO DO (4): from clip space to normalized coordinates, to [0, 1]; the closest depth that the map holds
  // there, the fragment's own, and 1.0 where that is larger.
  return 0.0;
}

void main() {
  fragment = reflected(1.0 - shadow_calculation(shadow_coord));
}
]]

function recipe.setup(r)
  local size = r.params.size
  r.flat = shader.load "flat"
  r.mapped = shader.compile{ vertex = vertex, fragment = fragment }

  -- The depth texture
  r.map = gl.GenTextures(1)
  gl.BindTexture(gl.TEXTURE_2D, r.map)
  gl.TexImage2D(gl.TEXTURE_2D, 0, gl.DEPTH_COMPONENT, size, size, 0, gl.DEPTH_COMPONENT, gl.FLOAT, nil)
  gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST)
  gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST)
  -- TO DO (1): the map ends around the teapot. What is outside of it is lit: how does the texture wrap, and
  -- what is its border's depth?

  -- Attached to a framebuffer, which draws no colour
  r.fbo = gl.GenFramebuffers(1)
  gl.BindFramebuffer(gl.FRAMEBUFFER, r.fbo)
  gl.FramebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.TEXTURE_2D, r.map, 0)
  gl.DrawBuffer(gl.NONE)
  gl.ReadBuffer(gl.NONE)
  gl.BindFramebuffer(gl.FRAMEBUFFER, 0)
end

function recipe.draw(r)
  local scene, camera, light, size = r.scene, r.scene.camera, r.params.light, r.params.size
  local view, projection = camera:view(), camera:projection(r.width / r.height)
  local center = vec3(-0.5, 0.8, -0.1)        -- of the teapot, which is in 1.3 metres of it

  gl.Enable(gl.DEPTH_TEST)
  -- TO DO (2): look at the centre from 4 metres toward the sun (light.xyz is any vector toward it), y up. The
  -- rays of the sun are parallel: a box of 1.3 metres to each side, from 1 to 9 metres ahead. Some cases have maps
  -- so coarse that their texels are seen: there another box, or one turned otherwise, is another picture.
  local light_view = mat4.identity()
  local light_projection = mat4.identity()

  pass("1. depth, from the sun", function()
    local bias = shadow.map_bias(light_projection, size)
    -- TO DO (3): the map's viewport and framebuffer; clear its depth; draw the scene with r.flat as the sun
    -- sees it, with a polygon offset of bias.factor, bias.units; the main framebuffer again.
  end)

  pass("2. the scene, with the map", function()
    gl.Viewport(0, 0, r.width, r.height)
    gl.ClearColor(0.85, 0.88, 0.92, 1)
    gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
    gl.BindTexture(gl.TEXTURE_2D, r.map)
    scene:draw(r.mapped, { view = view, projection = projection, light = light, shadow_map = 0,
                           light_matrix = light_projection * light_view * view:inverse(),
                           ambient = r.params.darkness })
  end)
end

return recipe
