// Thin dark lines over any colour.

uniform float u_opacity;

in vec3 v_position_E;
out vec4 o_color;

void main() {
  vec3 color = through_medium(vec3(0.08, 0.10, 0.13), v_position_E);
  o_color = vec4(color * u_opacity, u_opacity);
}
