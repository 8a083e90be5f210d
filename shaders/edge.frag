// Thin dark lines over any colour.

in vec3 v_position_E;
out vec4 o_color;

const float k_opacity = 0.4;

void main() {
  vec3 color = through_medium(vec3(0.08, 0.10, 0.13), v_position_E);
  o_color = vec4(color * k_opacity, k_opacity);
}
