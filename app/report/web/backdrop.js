// The sea behind everything: below the horizon, and around an eye under water, deep water ends the
// view where the drawn square of its surface does (shaders/sky.frag).
import * as THREE from "three";

const VERTEX = `
varying vec3 v_ray;
void main() {
  vec4 far = inverse(projectionMatrix) * vec4(position.xy, 1.0, 1.0);
  v_ray = transpose(mat3(viewMatrix)) * (far.xyz / far.w);
  gl_Position = vec4(position.xy, 1.0, 1.0);
}`;

const FRAGMENT = `
uniform vec3 u_color;   // of the water's surface, as displayed
uniform float u_above;  // height of the eye over the level
uniform float u_reach;  // at which the surface fades
varying vec3 v_ray;
void main() {
  vec3 ray = normalize(v_ray);
  // From above the water begins at the horizon, in whose haze the surface ends; from below it is
  // all around, lighter towards the surface.
  float drop = -ray.z * max(u_reach / max(u_above, 0.05 * u_reach), 1.0);
  float depth = u_above > 0.0 ? smoothstep(0.0, 1.0, drop) : smoothstep(0.5, -0.7, ray.z);
  float opacity = u_above > 0.0 ? depth : mix(0.75, 1.0, smoothstep(0.3, 0.0, ray.z));
  vec3 color = u_color * mix(0.9, 0.62, depth);
  gl_FragColor = vec4(color * opacity, opacity);
}`;

export class Backdrop {
  // level: of the water, in the replay
  constructor(color, level, reach) {
    this.level = level;
    const shown = new THREE.Color(color).convertLinearToSRGB();
    this.uniforms = {u_color: {value: new THREE.Vector3(shown.r, shown.g, shown.b)},
                     u_above: {value: 1}, u_reach: {value: reach}};
    // It is the first thing drawn, and the page behind the canvas shows where it lets light through.
    this.mesh = new THREE.Mesh(new THREE.PlaneGeometry(2, 2), new THREE.ShaderMaterial({
      uniforms: this.uniforms, vertexShader: VERTEX, fragmentShader: FRAGMENT, depthTest: false, depthWrite: false}));
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = -10;
  }

  update(camera) { this.uniforms.u_above.value = camera.position.z - this.level; }
}
