-- Includes a file of the system in a shader.
-- expect: recipe error
return {
  draw = function(r)
    shader.compile { vertex = "#version 330 core\n#include \"/etc/passwd\"\nvoid main() {}", fragment = "#version 330 core\nvoid main() {}" }
  end,
}
