#version 330 core
#include "full_screen.glsl"
