// Sand with a grid of lines for scale, fading into the water above it.

in vec3 v_position_E;
in vec3 v_normal;
out vec4 o_color;

const vec3 k_sand = vec3(0.83, 0.78, 0.67);
const vec3 k_absorption = vec3(9.0, 3.0, 1.1);  // of red, green and blue, in units of u_murk

void main() {
  vec3 normal = normalize(v_normal);
  vec2 cells = grid_cells(v_position_E);
  float line = grid_line(cells, dFdx(cells), dFdy(cells));
  vec3 color = k_sand * matt_light(normal, light_left(v_position_E)) * (1.0 - 0.13 * line);
  if (u_sea && v_position_E.z < u_level) {
    // Daylight loses its red first on the way down, so that sand is turquoise, then blue.
    vec3 left = exp(-u_murk * (u_level - v_position_E.z) * k_absorption);
    color = mix(k_deep * (0.75 + 0.25 * left), color * left, left.g);
  }
  o_color = vec4(through_medium(color, v_position_E), 1.0);
}
