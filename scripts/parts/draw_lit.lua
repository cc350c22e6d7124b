-- Draws a scene's objects, telling the shader which of them cast shadows: a caster's sides that are
-- turned from the light are in its own shadow.
return function(scene, shader, uniforms)
  for _, object in ipairs(scene.objects) do
    uniforms.casts = object.role ~= "receiver"
    object:draw(shader, uniforms)
  end
end
