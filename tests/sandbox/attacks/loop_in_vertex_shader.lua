-- A vertex shader that never stops.
-- expect: timed out
-- says: look for a loop
-- job: 1 s
return {
  draw = function(r)
    local s = shader.compile {
      vertex = "#version 330 core\nlayout(location = 0) in vec3 position;\nuniform float u = 1.0;\nvoid main() { float x = u; for (;;) { x = sin(x) + u; if (x < -5.0 * u) break; } gl_Position = vec4(position * x, 1); }",
      fragment = "#version 330 core\nout vec4 color;\nvoid main() { color = vec4(1); }",
    }
    mesh.plane(1, 1, 300, 300):draw(s)
  end,
}
