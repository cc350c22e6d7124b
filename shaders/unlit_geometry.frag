#version 330 core
#include "plain_color.glsl"
