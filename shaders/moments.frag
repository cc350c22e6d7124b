#version 330 core
#include "moments.glsl"
in float depth;
out vec4 moments;

void main() { moments = moments_of(clamp(depth, 0.0, 1.0)); }
