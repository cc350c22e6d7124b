-- hint: A part of the shadow is missing: the near plane of the sun's box cuts through the teapot, and what is before it is not in the map. Begin the box before all casters: at 1 metre.
-- hint.ca: Falta una part de l'ombra: el pla de retallat anterior de la caixa del sol travessa la tetera, i el que queda al davant no és al mapa. Comença la caixa abans de tots els oclusors: a 1 metre.
-- hint.es: Falta una parte de la sombra: el plano de recorte delantero de la caja del sol atraviesa la tetera, y lo que queda delante no está en el mapa. Empieza la caja antes de todos los oclusores: a 1 metro.
-- hint.fr: Il manque une partie de l'ombre : le plan proche de la boîte du soleil coupe la théière, et ce qui est devant n'est pas dans la carte. Commence la boîte avant tous les objets : à 1 mètre.

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
  vec3 projected = coord.xyz / coord.w;
  projected = projected * 0.5 + 0.5;
  float closest_depth = texture(shadow_map, projected.xy).r;
  float current_depth = projected.z;
  return current_depth > closest_depth ? 1.0 : 0.0;
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
  gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_BORDER)
  gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_BORDER)
  gl.TexParameterfv(gl.TEXTURE_2D, gl.TEXTURE_BORDER_COLOR, { 1, 1, 1, 1 })
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
  local light_view = mat4.look_at(center + light.xyz:normalize() * 4, center, vec3(0, 1, 0))
  local light_projection = mat4.ortho(-1.3, 1.3, -1.3, 1.3, 4.5, 9)

  pass("1. depth, from the sun", function()
    local bias = shadow.map_bias(light_projection, size)
    gl.Viewport(0, 0, size, size)
    gl.BindFramebuffer(gl.FRAMEBUFFER, r.fbo)
    gl.Clear(gl.DEPTH_BUFFER_BIT)
    gl.Enable(gl.POLYGON_OFFSET_FILL)
    gl.PolygonOffset(bias.factor, bias.units)
    scene:draw(r.flat, { view = light_view, projection = light_projection })
    gl.Disable(gl.POLYGON_OFFSET_FILL)
    gl.BindFramebuffer(gl.FRAMEBUFFER, 0)
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
