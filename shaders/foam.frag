// Adds up the faces of a body under water, those that face down less those that face up: what is left
// is the part of the water's surface that the body takes.

uniform float u_churn;  // how much the body churns the water, from 0 to 1

in float v_depth;
out vec4 o_color;

void main() {
  if (v_depth < 0.0) discard;
  float sign = gl_FrontFacing ? -1.0 : 1.0;
  o_color = vec4(0.0, 0.0, sign, sign * u_churn);
}
