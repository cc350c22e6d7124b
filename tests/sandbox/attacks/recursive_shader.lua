-- A shader whose functions call each other.
-- expect: recipe error
return {
  draw = function(r)
    shader.compile { vertex = "#version 330 core\nfloat f(float x);\nfloat g(float x) { return f(x); }\nfloat f(float x) { return g(x); }\nvoid main() { gl_Position = vec4(f(1.0)); }", fragment = "#version 330 core\nvoid main() {}" }
  end,
}
