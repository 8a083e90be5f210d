// A body in its own colour. Where the sea wets it, pressure.frag is drawn over this.

uniform vec3 u_color;
uniform bool u_painted;  // true: triangles have colours of their own

in vec3 v_position_E;
in vec3 v_normal;
in float v_open;
flat in vec3 v_color;
out vec4 o_color;

void main() {
  vec3 to_eye = -normalize(v_position_E);
  vec3 normal = normalize(v_normal);
  float rim = pow(1.0 - max(dot(normal, to_eye), 0.0), 3.0);
  vec3 half_way = normalize(u_key_light + to_eye);
  float gloss = 0.12 * pow(max(dot(normal, half_way), 0.0), 40.0);
  vec3 color = (u_painted ? v_color : u_color) * matt_light(normal, 1.0) * mix(0.45, 1.0, v_open) + 0.10 * rim * k_horizon + gloss;
  o_color = vec4(through_medium(color, v_position_E), 1.0);
}
