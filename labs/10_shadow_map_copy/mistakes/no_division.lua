-- hint: The shadow is too large and in the wrong place: under a perspective (s, t, p, q) is homogeneous, and only s/q, t/q and p/q are the place and the depth.
-- hint.ca: L'ombra és massa gran i fora de lloc: amb perspectiva (s, t, p, q) són coordenades homogènies, i només s/q, t/q i p/q són el lloc i la profunditat.
-- hint.es: La sombra es demasiado grande y está fuera de lugar: con perspectiva (s, t, p, q) son coordenadas homogéneas, y solo s/q, t/q y p/q son el lugar y la profundidad.
-- hint.fr: L'ombre est trop grande et mal placée : en perspective (s, t, p, q) est homogène, et seuls s/q, t/q et p/q sont la place et la profondeur.

local draw_lit = require "parts.draw_lit"

local recipe = {
  title   = "Lab 10: a shadow map, copied from the depth buffer",
  lecture = "000_178f3ee06912f876: Shadow mapping",
  scene   = "table",
  truth   = "hard",
  params  = { light = param.point(2, 4, 1), darkness = param.number(0.25, 0, 1) },
}

local vertex = [[
#version 330 core
// shadow_coord = light_matrix * the vertex in eye space: (s, t, p, q).
#include "shadow_coordinate.glsl"
]]

local fragment = [[
#version 330 core
#include "lighting.glsl"
in vec4 shadow_coord;
uniform sampler2D shadow_map;

void main() {
  vec2 st = shadow_coord.st;
  float true_depth = shadow_coord.p;
  float stored_depth = texture(shadow_map, st).r;
  float seen = true_depth <= stored_depth ? 1.0 : 0.0;
  fragment = reflected(seen);
}
]]

function recipe.setup(r)
  r.flat = shader.load "flat"
  r.mapped = shader.compile{ vertex = vertex, fragment = fragment }
  r.size = math.min(r.width, r.height)       -- the map is copied from the window, and no larger

  r.map = gl.GenTextures(1)
  gl.BindTexture(gl.TEXTURE_2D, r.map)
  gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_BORDER)
  gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_BORDER)
  gl.TexParameterfv(gl.TEXTURE_2D, gl.TEXTURE_BORDER_COLOR, { 1, 1, 1, 1 })
  gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST)
  gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST)
  gl.TexImage2D(gl.TEXTURE_2D, 0, gl.DEPTH_COMPONENT24, r.size, r.size, 0, gl.DEPTH_COMPONENT, gl.FLOAT, nil)
end

function recipe.draw(r)
  local scene, camera, light, size = r.scene, r.scene.camera, r.params.light, r.size
  local view, projection = camera:view(), camera:projection(r.width / r.height)
  -- gluLookAt and gluPerspective of a camera at the light, around the casters.
  local light_view, light_projection = shadow.light_view(light, scene, { fit = "scene" })
  local bias = shadow.map_bias(light_projection, size)
  gl.Enable(gl.DEPTH_TEST)

  pass("1. the shadow map", function()
    gl.Viewport(0, 0, size, size)
    gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
    gl.Enable(gl.POLYGON_OFFSET_FILL)
    gl.PolygonOffset(bias.factor, bias.units)
    scene.caster:draw(r.flat, { view = light_view, projection = light_projection })
    gl.Disable(gl.POLYGON_OFFSET_FILL)
    gl.BindTexture(gl.TEXTURE_2D, r.map)
    gl.CopyTexSubImage2D(gl.TEXTURE_2D, 0, 0, 0, 0, 0, size, size)
  end)

  pass("2. the scene, compared with the map", function()
    gl.Viewport(0, 0, r.width, r.height)
    gl.ClearColor(0.85, 0.88, 0.92, 1)
    gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
    local light_matrix = shadow.bias_matrix() * light_projection * light_view * view:inverse()
    draw_lit(scene, r.mapped, { view = view, projection = projection, light = light, shadow_map = 0,
                                light_matrix = light_matrix, ambient = r.params.darkness })
  end)
end

return recipe
