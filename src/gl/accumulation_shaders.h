// The passes of the accumulation buffer, in GLSL. Included by accumulation.cpp alone.
#pragma once

#include <string>

namespace shadowlab::gl {

inline constexpr const char* triangle_over_all = R"(#version 330 core
void main() {
  gl_Position = vec4(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1, 0, 1);
}
)";

// What a stored integer becomes is decided on integers alone, so that every GPU gives Mesa's bits:
// `table` holds what each of the 256 colours adds.
inline constexpr const char* integer_step = R"(#version 330 core
uniform isampler2D accumulated;
uniform sampler2D color;
uniform isampler2D table;
uniform int operation;  // 0 accum, 1 load, 2 add, 3 mult
uniform int bias;
uniform float factor;
uniform int half_range;
uniform ivec4 box;
out ivec4 result;

ivec4 wrapped(ivec4 v) { return ((v + half_range) & (2 * half_range - 1)) - half_range; }

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  ivec4 before = texelFetch(accumulated, at, 0);
  result = before;
  if (any(lessThan(at, box.xy)) || any(greaterThanEqual(at, box.xy + box.zw))) return;
  if (operation == 2) {
    result = wrapped(before + bias);
  } else if (operation == 3) {
    vec4 scaled = vec4(before) * factor;
    result = wrapped(ivec4(mix(scaled, vec4(0), greaterThanEqual(abs(scaled), vec4(2147483648.0)))));
  } else {
    ivec4 c = ivec4(round(texelFetch(color, at, 0) * 255.0));
    ivec4 added = ivec4(texelFetch(table, ivec2(c.r, 0), 0).r, texelFetch(table, ivec2(c.g, 0), 0).r,
                        texelFetch(table, ivec2(c.b, 0), 0).r, texelFetch(table, ivec2(c.a, 0), 0).r);
    result = operation == 1 ? added : wrapped(before + added);
  }
}
)";

inline constexpr const char* float_step = R"(#version 330 core
uniform sampler2D accumulated;
uniform sampler2D color;
uniform int operation;
uniform float factor;
uniform ivec4 box;
out vec4 result;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 before = texelFetch(accumulated, at, 0);
  result = before;
  if (any(lessThan(at, box.xy)) || any(greaterThanEqual(at, box.xy + box.zw))) return;
  if (operation == 2) {
    result = before + factor;
  } else if (operation == 3) {
    result = before * factor;
  } else {
    vec4 added = texelFetch(color, at, 0) * factor;
    result = operation == 1 ? added : before + added;
  }
}
)";

// Rounded here, to the nearest, and not by the driver's conversion to 8 bits.
inline std::string give_back_text(bool integral) {
  return std::string("#version 330 core\nuniform ") + (integral ? "isampler2D" : "sampler2D") +
         R"( accumulated;
uniform float factor;
out vec4 color;
void main() {
  vec4 value = vec4(texelFetch(accumulated, ivec2(gl_FragCoord.xy), 0)) * factor;
  color = roundEven(clamp(value, 0.0, 1.0) * 255.0) / 255.0;
}
)";
}

}  // namespace shadowlab::gl
