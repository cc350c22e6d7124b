-- Includes stock files in a circle, and ones that are not there.
-- expect: recipe error
return {
  draw = function(r)
    shader.compile { vertex = "#version 330 core\n#include \"phong.vert\"\n#include \"../scripts/room.lua\"\nvoid main() {}", fragment = "#version 330 core\nvoid main() {}" }
  end,
}
