// Blurs a texture along one of its axes, by a Gaussian of two texels' deviation. Its border is empty.

uniform sampler2D u_sharp;
uniform vec3 u_axis;  // step from texel to texel; its z is 0

out vec4 o_color;

const int k_reach = 5;  // [texels]

void main() {
  vec4 sum = vec4(0.0);
  float weights = 0.0;
  ivec2 last = textureSize(u_sharp, 0) - 1;
  ivec2 here = ivec2(gl_FragCoord.xy);
  for (int i = -k_reach; i <= k_reach; ++i) {
    float weight = exp(-0.125 * float(i * i));
    sum += weight * texelFetch(u_sharp, clamp(here + i * ivec2(u_axis.xy), ivec2(0), last), 0);
    weights += weight;
  }
  bool border = any(equal(here, ivec2(0))) || any(equal(here, last));
  o_color = border ? vec4(0.0) : sum / weights;
}
