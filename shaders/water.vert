// The water surface, given in E.

layout(location = 0) in vec3 a_position_E;
layout(location = 1) in vec2 a_slope;  // slopes of the height along x and y

out vec3 v_position_E;
out vec2 v_slope;

void main() {
  v_position_E = a_position_E;
  v_slope = a_slope;
  gl_Position = u_clip_from_E * vec4(a_position_E, 1.0);
}
