// Sky above the horizon; below it deep water if there is a sea, else a pale backdrop.

in vec3 v_ray;
out vec4 o_color;

void main() {
  vec3 ray = normalize(v_ray);
  vec3 color = sky(ray);
  if (ray.z < 0.0) {
    // The ray meets the sea here, so that deep water fades towards the horizon as the surface does.
    vec3 p_E = ray * max(-u_level, 0.0) / max(-ray.z, 1e-5);
    color = u_sea ? through_medium(k_deep, p_E) : mix(k_horizon, vec3(0.80, 0.83, 0.85), min(-1.5 * ray.z, 1.0));
  }
  if (u_under) color = mix(inner_water(ray), sky(ray), 0.5 * smoothstep(0.15, 0.8, ray.z));
  o_color = vec4(color, 1.0);
}
