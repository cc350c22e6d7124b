#version 330 core
// The visibility alone, for `shadowlab check`: white where the light reaches, black where not.
in vec3 eye_position;
in vec3 eye_normal;
uniform vec4 light;
uniform vec3 color;
uniform float ambient;
uniform float specular;
uniform float shininess;
uniform float lit = 1.0;
out vec4 fragment;

void main() { fragment = vec4(vec3(lit), 1.0); }
