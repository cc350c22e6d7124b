-- Stages that do not fit each other.
-- expect: recipe error
return {
  draw = function(r)
    shader.compile { vertex = "#version 330 core\nout vec4 a;\nvoid main() { gl_Position = a; }", fragment = "#version 330 core\nin vec3 a;\nin vec4 b;\nout vec4 c;\nvoid main() { c = b + vec4(a, 1); }" }
  end,
}
