// For stencil passes, whose colours are masked, and for pictures of what they draw.
uniform vec3 color;
uniform float alpha = 1.0;
out vec4 fragment;

void main() { fragment = vec4(color, alpha); }
