// Transforms the edges of a body's mesh from B to E.

layout(location = 0) in vec3 a_position_B;

uniform mat3 u_rotation;  // R_WB
uniform vec3 u_position;  // p_EB [m]

out vec3 v_position_E;

void main() {
  v_position_E = u_position + u_rotation * a_position_B;
  // Edges are moved a little towards the eye, so that the faces do not hide them.
  gl_Position = u_clip_from_E * vec4(0.999 * v_position_E, 1.0);
}
