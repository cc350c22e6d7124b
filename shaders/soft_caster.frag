#version 330 core
// The share of the light that a caster hides, whatever the picture shows of it.
#include "plain_color.glsl"
