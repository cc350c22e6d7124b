-- The reference itself: the exact visibility, ray traced, through the shaders that every other recipe
-- uses, so that pictures differ by the shadow alone. A light with a radius is a sphere, whose shadows
-- have penumbrae.
local recipe = {
  title   = "The ray-traced truth",
  lecture = "004_502e9deeb91da7bb: Raytracing",
  scene   = "table",
  truth   = "hard",
  params  = {
    light    = param.point(2, 4, 1),
    radius   = param.number(0, 0, 2),
    samples  = param.integer(64, 1, 4096),
  },
  sweep   = { samples = { 16, 64, 256 } },
}

function recipe.setup(r)
  r.phong = shader.load "phong"
end

function recipe.draw(r)
  local scene, camera = r.scene, r.scene.camera
  local light = r.params.light
  if r.params.radius > 0 then light = { center = light.xyz, radius = r.params.radius } end
  local view, projection = camera:view(), camera:projection(r.width / r.height)
  local visibility

  pass("1. rays from what each pixel sees to the light", function()
    visibility = shadow.truth(scene, camera, light, { samples = r.params.samples })
  end)

  pass("2. the scene, lit as far as the light is seen", function()
    gl.ClearColor(0.85, 0.88, 0.92, 1)
    gl.Clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
    gl.Enable(gl.DEPTH_TEST)
    gl.ActiveTexture(gl.TEXTURE0)
    gl.BindTexture(gl.TEXTURE_2D, visibility)
    scene:draw(r.phong, { view = view, projection = projection, light = light,
                           lit_by_texture = true, visibility = 0 })
  end)
end

return recipe
