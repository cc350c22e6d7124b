#version 330 core
// A box filter along one direction: the mean of 2 · reach + 1 texels.
uniform sampler2D image;
uniform ivec2 along;
uniform int reach = 1;
out vec4 mean;

void main() {
  ivec2 last = textureSize(image, 0) - 1;
  vec4 sum = vec4(0.0);
  for (int i = -reach; i <= reach; ++i)
    sum += texelFetch(image, clamp(ivec2(gl_FragCoord.xy) + i * along, ivec2(0), last), 0);
  mean = sum / float(2 * reach + 1);
}
