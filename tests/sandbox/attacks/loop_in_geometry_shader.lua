-- A geometry shader that never stops.
-- expect: timed out
-- says: look for a loop
-- job: 1 s
return {
  draw = function(r)
    local s = shader.compile {
      vertex = "#version 330 core\nlayout(location = 0) in vec3 position;\nvoid main() { gl_Position = vec4(position, 1); }",
      geometry = "#version 330 core\nlayout(triangles) in;\nlayout(triangle_strip, max_vertices = 3) out;\nuniform float u = 1.0;\nvoid main() { float x = u; for (;;) { x = sin(x) + u; if (x < -5.0 * u) break; } gl_Position = vec4(x); EmitVertex(); }",
      fragment = "#version 330 core\nout vec4 color;\nvoid main() { color = vec4(1); }",
    }
    mesh.plane(1, 1, 300, 300):draw(s)
  end,
}
