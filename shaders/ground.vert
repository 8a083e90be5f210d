// Sea floor or shore, given in E.

layout(location = 0) in vec3 a_position_E;
layout(location = 1) in vec3 a_normal;

out vec3 v_position_E;
out vec3 v_normal;

void main() {
  v_position_E = a_position_E;
  v_normal = a_normal;
  gl_Position = u_clip_from_E * vec4(a_position_E, 1.0);
}
