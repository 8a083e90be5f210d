// Draws a rigid body in plan, with all its heights at the level of the still water.

layout(location = 0) in vec3 a_position_B;
layout(location = 2) in vec2 a_heights;  // depth below the water surface (x) [m]

uniform mat3 u_rotation;  // R_WB
uniform vec3 u_position;  // p_EB [m]

out float v_depth;

void main() {
  v_depth = a_heights.x;
  gl_Position = vec4(2.0 * foam_place(u_position + u_rotation * a_position_B) - 1.0, 0.0, 1.0);
}
