#version 330 core
// Red from 255 at the left to 0 at the right, in steps of one.
uniform float width;  // of the picture, pixels
out vec4 fragment;

void main() {
  float level = 255.0 - floor(gl_FragCoord.x * 256.0 / width);
  fragment = vec4(level / 255.0, 0.0, 0.0, 1.0);
}
