#version 330 core
// A number from 0 to 255, written in every cell of the picture in digits of 3 × 5 dots; everything
// else is left alone. Drawn under a stencil test, it writes the stencil's values over the picture.
uniform int value;
uniform vec3 color = vec3(0.0);
uniform float cell = 32.0;    // pixels of a cell's side
uniform float dot_size = 2.0; // pixels of a dot's side
out vec4 fragment;

// A row a hexadecimal digit, from the top; the left dot is its highest bit of three.
const int digits[10] = int[10](0x25552, 0x26227, 0x71747, 0x71717, 0x55711,
                               0x74717, 0x74757, 0x71122, 0x75757, 0x75717);

void main() {
  int count = value > 99 ? 3 : value > 9 ? 2 : 1;
  vec2 size = vec2(float(4 * count - 1), 5.0) * dot_size;
  vec2 place = mod(gl_FragCoord.xy, cell) - floor((cell - size) / 2.0);
  if (any(lessThan(place, vec2(0.0))) || any(greaterThanEqual(place, size))) discard;
  ivec2 at = ivec2(place / dot_size);
  int digit = value;
  for (int i = count - 1; i > at.x / 4; --i) digit /= 10;
  int column = at.x % 4;
  if (column == 3 || ((digits[digit % 10] >> (4 * at.y + 2 - column)) & 1) == 0) discard;
  fragment = vec4(color, 1.0);
}
