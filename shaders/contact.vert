#version 330 core
// The sides of a shadow volume, in eye space and homogeneous: w falls from 1 at the edge that casts
// the shadow to 0 at infinity.
layout(location = 0) in vec4 position;  // w = 1: stays, w = 0: pushed to infinity
uniform vec4 volume_light;              // model space
uniform mat4 model_view;
uniform mat4 model_view_projection;
out vec4 eye;

void main() {
  vec4 p = position.w == 0.0 ? vec4(position.xyz * volume_light.w - volume_light.xyz, 0.0)
                             : vec4(position.xyz, 1.0);
  eye = model_view * p;
  gl_Position = model_view_projection * p;
}
