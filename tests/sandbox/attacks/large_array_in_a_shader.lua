-- An array of a gigabyte in a shader.
-- expect: recipe error or out of memory or crashed or timed out
-- job: 1.5 s
return {
  draw = function(r)
    mesh.quad():draw(shader.compile {
      vertex = "#version 330 core\nlayout(location = 0) in vec3 position;\nvoid main() { gl_Position = vec4(position, 1); }",
      fragment = "#version 330 core\nout vec4 color;\nvoid main() { float a[1 << 26]; a[int(gl_FragCoord.x)] = 1.0; color = vec4(a[int(gl_FragCoord.y)]); }",
    })
  end,
}
