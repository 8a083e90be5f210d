// The pressure on the wet part of a body, and the waterline. It is drawn over the finished picture of
// water and bodies: no light, water or air changes a colour of the scale, so that each pixel can be
// read against the bar. Colours are premultiplied by their opacity.

uniform sampler2D u_scale;      // colours of the pressure scale, from low to high
uniform float u_pressure_min;   // [Pa]
uniform float u_pressure_range; // [Pa]
uniform float u_stripe;         // period of the stripes beyond the scale [px]
uniform float u_weight;         // rho g [Pa/m]
uniform float u_drag_front;     // rho C_p / 2 where the surface moves into the water [Pa s^2/m^2]
uniform float u_drag_back;      // rho C_p / 2 where it moves out of the water [Pa s^2/m^2]
uniform float u_flat_depth;     // change of depth per pixel below which it is rounding [m]
uniform float u_line_width;     // width of the waterline [px]
uniform bool u_colored;         // false: the waterline alone is drawn
uniform bool u_bold;            // true: the waterline is bold

const vec3 k_line = vec3(0.97, 0.99, 1.0);
const vec3 k_bold_line = vec3(0.88, 0.05, 0.52);  // a hue that no pressure has
const float k_beyond = 0.005;  // part of the scale beyond an end that is rounding

in vec3 v_position_E;
in vec3 v_normal;
in vec3 v_velocity;
in float v_depth;
in float v_head;
in float v_open;
out vec4 o_color;

// Returns the colour of a pressure. Beyond the ends of the scale it is striped with white or black,
// as the ends of the bar are (overlay.cpp).
vec3 pressure_color(float pressure) {
  float place = (pressure - u_pressure_min) / u_pressure_range;
  float colors = float(textureSize(u_scale, 0).x);
  vec3 color = texture(u_scale, vec2((clamp(place, 0.0, 1.0) * (colors - 1.0) + 0.5) / colors, 0.5)).rgb;
  if (place >= -k_beyond && place <= 1.0 + k_beyond) return color;
  float across = fract((gl_FragCoord.x + gl_FragCoord.y) / u_stripe);
  return across < 0.5 ? color : vec3(place > 0.0 ? 1.0 : 0.0);
}

void main() {
  float slope = length(vec2(dFdx(v_depth), dFdy(v_depth)));
  // A face in the water surface itself is dry and has no waterline.
  bool level = slope < u_flat_depth;
  float depth_px = level ? v_depth / u_flat_depth - 8.0 : v_depth / slope;
  float wet = u_colored ? clamp(depth_px + 0.5, 0.0, 1.0) : 0.0;
  float edge = 0.5 * u_line_width;
  float line = level ? 0.0 : 1.0 - smoothstep(edge - 0.5, edge + 0.5, abs(depth_px));
  if (!u_bold) line *= 0.8;
  float speed = dot(v_velocity, normalize(v_normal));
  float drag = speed > 0.0 ? u_drag_front : u_drag_back;
  vec3 color = pressure_color(u_weight * v_head + drag * speed * abs(speed));
  o_color = mix(vec4(color * wet, wet), vec4(u_bold ? k_bold_line : k_line, 1.0), line);
}
