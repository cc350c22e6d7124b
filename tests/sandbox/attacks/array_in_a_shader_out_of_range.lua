-- Reads far outside of an array in a shader.
-- expect: finished or recipe error or crashed
return {
  draw = function(r)
    mesh.quad():draw(shader.compile {
      vertex = "#version 330 core\nlayout(location = 0) in vec3 position;\nvoid main() { gl_Position = vec4(position, 1); }",
      fragment = "#version 330 core\nout vec4 color;\nvoid main() { float a[16]; for (int i = 0; i < 16; ++i) a[i] = 0.5; color = vec4(a[int(gl_FragCoord.x) * 100000 - 7]); }",
    })
  end,
}
