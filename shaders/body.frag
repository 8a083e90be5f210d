// A body in its own colour. Where the sea wets it, pressure.frag is drawn over this.

uniform vec3 u_color;
uniform bool u_painted;  // true: triangles have colours of their own
uniform bool u_textured;  // true: a texture multiplies them
uniform bool u_of_light;  // true: light is multiplied (glTF), false: values as displayed (MTL)
uniform sampler2D u_texture;

in vec3 v_position_E;
in vec3 v_normal;
in float v_open;
flat in vec3 v_color;
centroid in vec2 v_coordinates;
out vec4 o_color;

// Returns the linear share of light of a displayed value (IEC 61966-2-1, sRGB), and the reverse.
vec3 light_of(vec3 shown) {
  return mix(shown / 12.92, pow((shown + 0.055) / 1.055, vec3(2.4)), step(0.04045, shown));
}
vec3 displayed(vec3 light) {
  return mix(12.92 * light, 1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, light));
}

// Returns the surface's own colour, as displayed.
vec3 own_color() {
  if (!u_textured) return u_painted ? v_color : u_color;
  vec3 texel = texture(u_texture, v_coordinates).rgb;
  return u_of_light ? displayed(light_of(texel) * light_of(v_color)) : texel * v_color;
}

void main() {
  vec3 to_eye = -normalize(v_position_E);
  vec3 normal = normalize(v_normal);
  float rim = pow(1.0 - max(dot(normal, to_eye), 0.0), 3.0);
  vec3 half_way = normalize(u_key_light + to_eye);
  float gloss = 0.12 * pow(max(dot(normal, half_way), 0.0), 40.0);
  vec3 color = own_color() * matt_light(normal, 1.0) * mix(0.45, 1.0, v_open) + 0.10 * rim * k_horizon + gloss;
  o_color = vec4(through_medium(color, v_position_E), 1.0);
}
