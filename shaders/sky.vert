// A triangle that covers the picture behind all other objects.

uniform vec3 u_forward;  // the ray through the middle of the picture
uniform vec3 u_right;    // change of the ray from there to the right border
uniform vec3 u_up;       // change of the ray from there to the upper border

out vec3 v_ray;

void main() {
  vec2 corner = covering_corner(gl_VertexID);
  v_ray = u_forward + corner.x * u_right + corner.y * u_up;
  gl_Position = vec4(corner, 1.0, 1.0);
}
