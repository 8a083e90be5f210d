// Sand with a grid of lines for scale, fading into the water above it.

in vec3 v_position_E;
in vec3 v_normal;
out vec4 o_color;

const vec3 k_sand = vec3(0.83, 0.78, 0.67);

void main() {
  vec3 normal = normalize(v_normal);
  vec2 cells = grid_cells(v_position_E);
  float line = grid_line(cells, dFdx(cells), dFdy(cells));
  vec3 color = k_sand * matt_light(normal) * (1.0 - 0.13 * line);
  float depth = u_sea ? max(u_level - v_position_E.z, 0.0) : 0.0;
  color = mix(k_deep, color, exp(-2.0 * u_murk * depth));
  o_color = vec4(through_medium(color, v_position_E), 1.0);
}
