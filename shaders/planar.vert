#version 330 core
#include "flattened.glsl"
