// For a full-screen quad: nothing is transformed.
layout(location = 0) in vec3 position;

void main() { gl_Position = vec4(position, 1.0); }
