#version 330 core
#include "shadow_coordinate.glsl"
