// Blurs a texture along one of its axes by a Gaussian, whose deviation is 2 texels for the shadows in
// the first channels and 6 for the foam in the last ones. Its border is empty.

uniform sampler2D u_sharp;
uniform vec3 u_axis;  // step from texel to texel; its z is 0

out vec4 o_color;

const int k_reach = 5;  // [steps]
const int k_step = 3;   // of the foam [texels]

void main() {
  vec4 sum = vec4(0.0);
  float weights = 0.0;
  ivec2 last = textureSize(u_sharp, 0) - 1;
  ivec2 here = ivec2(gl_FragCoord.xy);
  for (int i = -k_reach; i <= k_reach; ++i) {
    float weight = exp(-0.125 * float(i * i));
    ivec2 step = i * ivec2(u_axis.xy);
    sum.rg += weight * texelFetch(u_sharp, clamp(here + step, ivec2(0), last), 0).rg;
    sum.ba += weight * texelFetch(u_sharp, clamp(here + k_step * step, ivec2(0), last), 0).ba;
    weights += weight;
  }
  bool border = any(equal(here, ivec2(0))) || any(equal(here, last));
  o_color = border ? vec4(0.0) : sum / weights;
}
