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
uniform bool lit_by_texture = false;
uniform sampler2D visibility;
out vec4 fragment;

void main() {
  float seen = lit_by_texture ? texelFetch(visibility, ivec2(gl_FragCoord.xy), 0).r : lit;
  fragment = vec4(vec3(seen), 1.0);
}
