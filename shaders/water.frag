// The water surface. It absorbs light from behind according to the length of water on the way, and
// reflects the sky by Fresnel's law in the approximation of C. Schlick, An inexpensive BRDF model
// for physically-based rendering, Eurographics 1994. Colours are premultiplied by their opacity.

uniform sampler2DMS u_depth;  // depth buffer of the objects behind the water
uniform float u_near;         // [m]
uniform float u_far;          // [m]

in vec3 v_position_E;
in vec2 v_slope;
out vec4 o_color;

const int k_samples = 4;
const float k_most_reflected = 0.25;  // in front of objects, so that they are seen
const float k_shaded = 0.7;           // share of the light of water in full shadow
const float k_most_foam = 0.75;       // opacity, at a hull that churns the water as much as can be
const float k_most_tint = 0.6;        // on objects, so that they are seen at any depth
const int k_patches = 32;             // cells of the foam along one of the grid of lines; a power of 2
const vec3 k_foam = vec3(0.93, 0.96, 0.97);

// Returns the share of the light from behind that the water absorbs, averaged over those samples of
// the pixel that have an object behind them. Samples without an object show deep water already, so
// that outlines under water stay smooth.
float tint(float surface_depth, float stretch) {
  float sum = 0.0;
  float count = 0.0;
  for (int i = 0; i < k_samples; ++i) {
    float z = 2.0 * texelFetch(u_depth, ivec2(gl_FragCoord.xy), i).r - 1.0;
    if (z >= 1.0) continue;
    float depth = 2.0 * u_far * u_near / (u_far + u_near - z * (u_far - u_near));
    float water = max(depth - surface_depth, 0.0) * stretch;
    sum += k_most_tint * (1.0 - exp(-u_murk * water / k_most_tint));
    count += 1.0;
  }
  return count > 0.0 ? sum / count : 1.0;
}

// Returns a fixed pseudorandom number from 0 to 1 for a cell of a pattern that repeats.
float noise(ivec2 cell) {
  uvec2 c = uvec2(cell & (k_patches - 1));
  uint mixed = (c.x * 1597334677u) ^ (c.y * 3812015801u);
  return float((mixed * 1597334677u) >> 16 & 0xffffu) / 65535.0;
}

// Returns the opacity of the foam. Its patches are the same in each cell of the grid of lines.
float foam(vec3 p_E) {
  vec2 taken = texture(u_plan, foam_place(p_E)).ba;
  if (taken.y < 0.01) return 0.0;
  vec2 place = float(k_patches) * fract(grid_cells(p_E));
  ivec2 cell = ivec2(floor(place));
  vec2 f = smoothstep(0.0, 1.0, place - vec2(cell));
  float patches = mix(mix(noise(cell), noise(cell + ivec2(1, 0)), f.x),
                      mix(noise(cell + ivec2(0, 1)), noise(cell + ivec2(1, 1)), f.x), f.y);
  float most = clamp(2.0 * taken.y, 0.0, 1.0);  // at the edge of a body the blur leaves the half
  float outside = 1.0 - smoothstep(0.5, 0.7, taken.x);
  return k_most_foam * outside * smoothstep(0.0, 0.9, most * (0.5 + patches));
}

float fresnel(float cosine) { return 0.02 + 0.98 * pow(1.0 - clamp(cosine, 0.0, 1.0), 5.0); }

// Returns the colour seen from above.
vec4 upper_side(vec3 normal, vec3 to_eye) {
  float surface_depth = 1.0 / gl_FragCoord.w;
  float body = tint(surface_depth, length(v_position_E) / surface_depth);
  vec3 mirrored = reflect(-to_eye, normal);
  mirrored.z = abs(mirrored.z);
  float most = body < 1.0 ? k_most_reflected : 0.65;
  float reflected = min(fresnel(dot(normal, to_eye)), most);
  float glitter = 0.5 * pow(max(dot(mirrored, u_back_light), 0.0), 60.0);
  vec3 scattered = mix(k_shallow, k_deep, smoothstep(0.0, k_most_tint, body)) * (0.9 + 0.5 * dot(vec3(-v_slope, 0.0), u_key_light));
  scattered += 0.10 * clamp(length(v_slope), 0.0, 1.0) * k_shallow;
  scattered *= mix(k_shaded, 1.0, light_left(v_position_E));
  vec3 color = mix(scattered * body, sky(mirrored), reflected) + glitter * reflected;
  vec2 cells = grid_cells(v_position_E);
  float line = 0.10 * grid_line(cells, dFdx(cells), dFdy(cells));
  vec4 water = mix(vec4(color, 1.0 - (1.0 - body) * (1.0 - reflected)), vec4(1.0), line);
  return mix(water, vec4(k_foam, 1.0), foam(v_position_E));
}

// Returns the colour seen from below: the deep water is reflected outside Snell's window.
vec4 lower_side(vec3 normal, vec3 to_eye) {
  float cosine = clamp(-dot(normal, to_eye), 0.0, 1.0);
  float mirror = 1.0 - smoothstep(0.55, 0.8, cosine);
  vec3 color = mix(k_shallow, inner_water(vec3(0.0, 0.0, 0.2)), mirror);
  color += 0.25 * k_shallow * dot(v_slope, u_key_light.xy);
  float opacity = mix(0.35, 0.8, mirror);
  return vec4(color * opacity, opacity);
}

void main() {
  vec3 normal = normalize(vec3(-v_slope, 1.0));
  vec3 to_eye = -normalize(v_position_E);
  vec4 color = u_under ? lower_side(normal, to_eye) : upper_side(normal, to_eye);
  float haze = u_under ? 1.0 - exp(-0.5 * u_murk * length(v_position_E))
                       : 1.0 - exp(-pow(length(v_position_E) / u_visibility, 1.5));
  vec3 far_color = u_under ? inner_water(v_position_E) : k_horizon;
  o_color = mix(color, vec4(far_color, 1.0), haze);
}
