-- Macros that grow to 2^40 words.
-- expect: recipe error or timed out or out of memory or crashed
-- job: 1.5 s
return {
  draw = function(r)
    local lines = { "#version 330 core", "#define A0 1.0 + 1.0" }
    for i = 1, 40 do lines[#lines + 1] = ("#define A%d A%d + A%d"):format(i, i - 1, i - 1) end
    lines[#lines + 1] = "void main() { gl_Position = vec4(A40); }"
    shader.compile { vertex = table.concat(lines, "\n"), fragment = "#version 330 core\nvoid main() {}" }
  end,
}
