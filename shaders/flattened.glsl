// A caster flattened onto a plane by its model matrix. What is below the plane throws no shadow on
// it, though the matrix maps it there too: with CLIP_DISTANCE0 enabled it is cut off.
layout(location = 0) in vec3 position;
uniform mat4 model_view_projection;
// The plane in the caster's own space, positive toward the light; unset, all is above it.
uniform vec4 above = vec4(0.0, 0.0, 0.0, 1.0);
invariant gl_Position;

void main() {
  gl_Position = model_view_projection * vec4(position, 1.0);
  gl_ClipDistance[0] = dot(above, vec4(position, 1.0));
}
