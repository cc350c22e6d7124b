-- A shader that takes minutes to compile.
-- expect: timed out or out of memory or recipe error
-- job: 1.5 s
return {
  draw = function(r)
    local lines = {}
    for i = 1, 6000 do lines[i] = ("x = mix(sin(x * %d.0), cos(y + x), fract(x)); y = sqrt(abs(y - x)) * tan(x);"):format(i) end
    local s = shader.compile {
      vertex = "#version 330 core\nlayout(location = 0) in vec3 position;\nvoid main() { gl_Position = vec4(position, 1); }",
      fragment = "#version 330 core\nout vec4 color;\nvoid main() { float x = gl_FragCoord.x, y = gl_FragCoord.y;\n" .. table.concat(lines, "\n") .. "\ncolor = vec4(x, y, 0, 1); }",
    }
    mesh.quad():draw(s)
  end,
}
