// The body's own colour above the water and the colour of its pressure below; they meet at depth 0.

uniform vec3 u_color;
uniform sampler2D u_scale;      // colours of the pressure scale, from low to high
uniform float u_pressure_min;   // [Pa]
uniform float u_pressure_range; // [Pa]
uniform float u_weight;         // rho g [Pa/m]
uniform float u_drag_front;     // rho C_p / 2 where the surface moves into the water [Pa s^2/m^2]
uniform float u_drag_back;      // rho C_p / 2 where it moves out of the water [Pa s^2/m^2]
uniform float u_flat_depth;     // change of depth per pixel below which it is rounding [m]
uniform float u_line_width;     // width of the waterline [px]
uniform bool u_bold;            // true: the waterline is bold

const vec3 k_line = vec3(0.97, 0.99, 1.0);
const vec3 k_bold_line = vec3(0.88, 0.05, 0.52);  // a hue that no pressure has

in vec3 v_position_E;
in vec3 v_normal;
in vec3 v_velocity;
in float v_depth;
in float v_head;
in float v_open;
out vec4 o_color;

vec3 pressure_color(float pressure) {
  float place = clamp((pressure - u_pressure_min) / u_pressure_range, 0.0, 1.0);
  float colors = float(textureSize(u_scale, 0).x);
  return texture(u_scale, vec2((place * (colors - 1.0) + 0.5) / colors, 0.5)).rgb;
}

vec3 dry_color(vec3 normal, vec3 to_eye) {
  float rim = pow(1.0 - max(dot(normal, to_eye), 0.0), 3.0);
  vec3 half_way = normalize(u_key_light + to_eye);
  float gloss = 0.12 * pow(max(dot(normal, half_way), 0.0), 40.0);
  return u_color * matt_light(normal) * mix(0.45, 1.0, v_open) + 0.10 * rim * k_horizon + gloss;
}

// Shading changes only the brightness, and little, so that a colour can be found on the scale.
vec3 wet_color(vec3 normal) {
  float speed = dot(v_velocity, normal);
  float drag = speed > 0.0 ? u_drag_front : u_drag_back;
  float pressure = u_weight * v_head + drag * speed * abs(speed);
  float facing = 0.5 + 0.5 * dot(normal, u_key_light);
  return pressure_color(pressure) * (0.74 + 0.26 * facing) * mix(0.8, 1.0, v_open);
}

void main() {
  vec3 to_eye = -normalize(v_position_E);
  vec3 normal = normalize(v_normal);
  float slope = length(vec2(dFdx(v_depth), dFdy(v_depth)));
  // A face in the water surface itself is dry and has no waterline.
  bool level = slope < u_flat_depth;
  float depth_px = level ? v_depth / u_flat_depth - 8.0 : v_depth / slope;
  float wet = u_sea ? clamp(depth_px + 0.5, 0.0, 1.0) : 0.0;
  vec3 color = mix(dry_color(normal, to_eye), wet_color(normal), wet);
  float edge = 0.5 * u_line_width;
  float line = u_sea && !level ? 1.0 - smoothstep(edge - 0.5, edge + 0.5, abs(depth_px)) : 0.0;
  color = u_bold ? mix(color, k_bold_line, line) : mix(color, k_line, 0.8 * line);
  o_color = vec4(through_medium(color, v_position_E), 1.0);
}
