// Transforms a rigid body from B to E, with the velocity of its surface relative to the water as
// pressure drag sees it.

layout(location = 0) in vec3 a_position_B;
layout(location = 1) in vec3 a_normal_B;
layout(location = 2) in vec2 a_heights;  // depth below the water surface and head p/(rho g) [m]
layout(location = 3) in float a_open;    // share of the sky that the body itself does not hide
layout(location = 4) in vec3 a_flow;     // velocity of the water relative to the current, W [m/s]
layout(location = 5) in vec3 a_color;    // of the triangle, where they have colours of their own
layout(location = 6) in vec2 a_coordinates;  // in the triangle's texture, where it has one

uniform mat3 u_rotation;  // R_WB
uniform vec3 u_position;  // p_EB [m]
uniform vec3 u_velocity;  // velocity of B's origin relative to the current, in W [m/s]
uniform vec3 u_spin;      // angular velocity, in W [rad/s]
uniform mat3 u_drag_shape;  // K of hydro/loads/bluntness.h, in W

// Both passes of a body must cover the same samples.
invariant gl_Position;

out vec3 v_position_E;
out vec3 v_normal;
out vec3 v_velocity;
out float v_depth;
out float v_head;
out float v_open;
flat out vec3 v_color;
centroid out vec2 v_coordinates;  // not beyond the triangle, where its texture has other parts

void main() {
  vec3 arm = u_rotation * a_position_B;
  v_position_E = u_position + arm;
  v_normal = u_rotation * a_normal_B;
  v_velocity = u_drag_shape * (u_velocity - a_flow) + cross(u_spin, arm);
  v_depth = a_heights.x;
  v_head = a_heights.y;
  v_open = a_open;
  v_color = a_color;
  v_coordinates = a_coordinates;
  gl_Position = u_clip_from_E * vec4(v_position_E, 1.0);
}
