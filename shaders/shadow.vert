// Casts a rigid body along the main light onto the level plane through the eye.

layout(location = 0) in vec3 a_position_B;

uniform mat3 u_rotation;  // R_WB
uniform vec3 u_position;  // p_EB [m]

out float v_height;

void main() {
  vec3 p_E = u_position + u_rotation * a_position_B;
  v_height = (p_E.z - u_cast_low) / u_cast_range;
  gl_Position = vec4(2.0 * plan_place(p_E) - 1.0, 0.0, 1.0);
}
