// The view and the light, shared by all shaders; each is compiled after this file.
//
// Frame E: axes of the world, z up, origin in the camera's eye. Lengths in m. Colours are as
// displayed (sRGB) and shading multiplies them, so that it keeps the hues of the pressure scale.

uniform mat4 u_clip_from_E;
uniform vec3 u_key_light;    // toward the main light, unit, over the camera's left shoulder
uniform vec3 u_back_light;   // toward the light that glitters on the water, unit
uniform float u_visibility;  // distance at which objects fade into the air [m]
uniform float u_murk;        // absorption of the water [1/m]
uniform float u_level;       // z of the still water in E [m]
uniform bool u_sea;          // true: there is water
uniform bool u_under;        // true: the eye is under water
uniform float u_grid;        // spacing of the grid lines on ground and water [m]
uniform bool u_grid_lines;   // true: these lines are drawn
uniform vec3 u_grid_shift;   // the eye's position in its cell of that grid [m]
uniform sampler2D u_plan;    // share of the main light that bodies take (r), that times their height
                             // (g), share of the water's surface that they take (b), and that
                             // times how much they churn it (a)
uniform vec3 u_plan_part;    // middle of what u_plan covers, as a point of E cast along the light
                             // onto z = 0 (x, y) [m], and 1 over the length of a side (z) [1/m]
uniform float u_cast_low;    // z of the height 0 in u_plan, in E [m]
uniform float u_cast_range;  // from there to the height 1 [m]

const vec3 k_zenith = vec3(0.50, 0.69, 0.88);
const vec3 k_horizon = vec3(0.90, 0.94, 0.965);
const vec3 k_deep = vec3(0.14, 0.39, 0.51);     // deep water seen from above
const vec3 k_shallow = vec3(0.29, 0.58, 0.74);  // water lit from above, seen from within

// Returns the colour of the sky in a direction, and that of the horizon below it.
vec3 sky(vec3 direction) {
  float up = normalize(direction).z;
  return mix(k_horizon, k_zenith, pow(clamp(up * 1.6, 0.0, 1.0), 0.6));
}

// Returns the colour of the water in a direction, for an eye under water.
vec3 inner_water(vec3 direction) {
  return mix(k_deep, k_shallow, smoothstep(-0.7, 0.9, normalize(direction).z));
}

// Returns a colour at p_E as it is seen by the eye through air or water.
vec3 through_medium(vec3 color, vec3 p_E) {
  float distance = length(p_E);
  if (u_under) return mix(inner_water(p_E), color, exp(-0.5 * u_murk * distance));
  return mix(k_horizon, color, exp(-pow(distance / u_visibility, 1.5)));
}

// Returns coordinates in the grid of lines, one unit per cell.
vec2 grid_cells(vec3 p_E) { return (p_E.xy + u_grid_shift.xy) / u_grid; }

// Returns 1 on a grid line, 0 off it. Lines are 1.5 pixels wide and fade out where cells are too
// small. `right` and `up` are the changes of `cells` from one pixel to the next.
float grid_line(vec2 cells, vec2 right, vec2 up) {
  vec2 per_pixel = max(vec2(length(vec2(right.x, up.x)), length(vec2(right.y, up.y))), 1e-6);
  vec2 off_line = abs(fract(cells - 0.5) - 0.5) / per_pixel;
  vec2 line = (1.0 - smoothstep(0.3, 1.3, off_line)) * (1.0 - smoothstep(0.05, 0.25, per_pixel));
  return u_grid_lines ? max(line.x, line.y) : 0.0;
}

// Returns the light on a matt surface: about 1 where it faces the main light, never below 0.5.
// `left` is the share of the main light that reaches it.
float matt_light(vec3 normal, float left) {
  float sky_part = 0.5 + 0.5 * normal.z;
  float key = left * max(dot(normal, u_key_light), 0.0);
  return 0.56 + 0.16 * sky_part + 0.36 * key;
}

// Returns a corner of the triangle that covers the whole of a picture or texture, by its number.
vec2 covering_corner(int vertex) { return vec2(vertex == 1 ? 3.0 : -1.0, vertex == 2 ? 3.0 : -1.0); }

// Returns the place in u_plan of the points that lie on the ray of the main light through p_E.
vec2 plan_place(vec3 p_E) {
  vec2 on_plane = p_E.xy - p_E.z / u_key_light.z * u_key_light.xy;
  return 0.5 + u_plan_part.z * (on_plane - u_plan_part.xy);
}

// Returns the place in u_plan of the foam above or below p_E.
vec2 foam_place(vec3 p_E) { return plan_place(vec3(p_E.xy, u_level)); }

// Returns the share of the main light that bodies above p_E leave to it.
float light_left(vec3 p_E) {
  vec2 taken = texture(u_plan, plan_place(p_E)).rg;
  return p_E.z < u_cast_low + u_cast_range * taken.y / max(taken.x, 1e-6) ? 1.0 - taken.x : 1.0;
}
