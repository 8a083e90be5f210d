// The pressure on the wet part of the bodies, in the colours of the pictures (shaders/pressure.frag).
// It is drawn over the water, so that each colour can be read against the bar. Heads are those of
// one wave number, and the water of waves is taken as at rest.
import * as THREE from "three";
import {octets} from "./data.js";
import {element} from "./format.js";

const STRIPE = 8;  // px, of pressures beyond the scale

const VERTEX = `
attribute vec3 i_velocity, i_spin, i_diagonal, i_mixed;
attribute vec2 i_drag;
varying vec3 v_place, v_normal, v_velocity;
varying vec2 v_drag;
void main() {
  mat3 R = mat3(instanceMatrix);
  mat3 K = mat3(i_diagonal.x, i_mixed.x, i_mixed.y, i_mixed.x, i_diagonal.y, i_mixed.z,
                i_mixed.y, i_mixed.z, i_diagonal.z);
  vec4 place = instanceMatrix * vec4(position, 1.0);
  v_place = place.xyz;
  v_normal = R * normal;
  v_velocity = R * (K * (transpose(R) * i_velocity)) + cross(i_spin, R * position);
  v_drag = i_drag;
  gl_Position = projectionMatrix * modelViewMatrix * place;
}`;

const FRAGMENT = `
uniform highp sampler2D u_heights;  // of the surface above its level, on the grid of surface.js
uniform sampler2D u_colors;
uniform vec2 u_corner;
uniform float u_cell, u_level, u_wave, u_weight, u_low, u_range, u_stripe;
varying vec3 v_place, v_normal, v_velocity;
varying vec2 v_drag;

float height_at(vec2 place) {
  ivec2 last = textureSize(u_heights, 0) - 1;
  vec2 cells = clamp((place - u_corner) / u_cell, vec2(0.0), vec2(last));
  ivec2 a = min(ivec2(cells), last - 1);
  vec2 part = cells - vec2(a);
  float low = mix(texelFetch(u_heights, a, 0).r, texelFetch(u_heights, a + ivec2(1, 0), 0).r, part.x);
  float high = mix(texelFetch(u_heights, a + ivec2(0, 1), 0).r, texelFetch(u_heights, a + 1, 0).r, part.x);
  return mix(low, high, part.y);
}

void main() {
  float height = height_at(v_place.xy), z = v_place.z - u_level;
  float depth = height - z;
  float width = max(fwidth(depth), 1e-6);
  if (depth < -width) discard;
  float head = z < 0.0 ? height * exp(u_wave * z) - z : depth;
  float speed = dot(v_velocity, normalize(v_normal));
  float pressure = u_weight * head + (speed > 0.0 ? v_drag.x : v_drag.y) * speed * abs(speed);
  float place = (pressure - u_low) / u_range;
  vec3 color = texture2D(u_colors, vec2((clamp(place, 0.0, 1.0) * 255.0 + 0.5) / 256.0, 0.5)).rgb;
  bool beyond = place < -0.005 || place > 1.005;
  if (beyond && fract((gl_FragCoord.x + gl_FragCoord.y) / u_stripe) > 0.5) color = vec3(place > 0.0 ? 1.0 : 0.0);
  gl_FragColor = vec4(mix(color, vec3(1.0), 1.0 - smoothstep(0.5, 1.5, abs(depth) / width)), 1.0);
}`;

const colorsOf = (pressure) => octets(pressure.colors);

export class Pressure {
  // meshes: the bodies as instances; surface: the water's (surface.js)
  constructor(pressure, meshes, surface, pixels) {
    this.pressure = pressure;
    this.surface = surface;
    this.group = new THREE.Group();
    const rgb = colorsOf(pressure), rgba = new Uint8Array(4 * rgb.length / 3).fill(255);
    for (let i = 0; i < rgb.length; ++i) rgba[4 * Math.floor(i / 3) + i % 3] = rgb[i];
    const colors = new THREE.DataTexture(rgba, rgba.length / 4, 1);
    colors.minFilter = colors.magFilter = THREE.LinearFilter;
    colors.needsUpdate = true;
    const {count} = surface;
    this.heights = new THREE.DataTexture(new Float32Array(count ** 2), count, count, THREE.RedFormat, THREE.FloatType);
    this.uniforms = {
      u_heights: {value: this.heights}, u_colors: {value: colors}, u_corner: {value: new THREE.Vector2()},
      u_cell: {value: surface.cell}, u_level: {value: 0}, u_wave: {value: pressure.wave_number},
      u_weight: {value: pressure.weight}, u_low: {value: pressure.min},
      u_range: {value: pressure.max - pressure.min}, u_stripe: {value: STRIPE * pixels}};
    // Its sides are those of the bodies that it is drawn over.
    const material = new THREE.ShaderMaterial({uniforms: this.uniforms, vertexShader: VERTEX, fragmentShader: FRAGMENT,
      polygonOffset: true, polygonOffsetFactor: -1, polygonOffsetUnits: -1, transparent: true, depthWrite: false});
    this.skins = meshes.map((mesh) => this.skinOf(mesh, material));
  }

  skinOf(mesh, material) {
    const {drags, half_density: half} = this.pressure;
    const count = mesh.bodies.length;
    const attribute = (size, numbers = new Float32Array(size * count)) =>
      new THREE.InstancedBufferAttribute(numbers, size);
    const of = (size, first, factor) => attribute(size, Float32Array.from(
      mesh.bodies.flatMap((body) => drags[body].slice(first, first + size).map((x) => factor * x))));
    const {geometry} = mesh;
    geometry.setAttribute("i_drag", of(2, 0, half));
    geometry.setAttribute("i_diagonal", of(3, 2, 1));
    geometry.setAttribute("i_mixed", of(3, 5, 1));
    geometry.setAttribute("i_velocity", attribute(3));
    geometry.setAttribute("i_spin", attribute(3));
    const skin = new THREE.InstancedMesh(geometry, material, count);
    skin.instanceMatrix = mesh.instanceMatrix;
    skin.frustumCulled = false;
    skin.renderOrder = 2.5;  // after the water, before paths and axes
    this.group.add(skin);
    return skin;
  }

  // motionOf(body): {velocity, spin} [m/s, rad/s]; origin: the world's place of (0, 0, 0)
  update(motionOf, meshes, origin) {
    const [u, v, w] = this.pressure.current;
    meshes.forEach((mesh, shape) => {
      const {i_velocity: velocities, i_spin: spins} = this.skins[shape].geometry.attributes;
      mesh.bodies.forEach((body, k) => {
        const {velocity, spin} = motionOf(body);
        velocities.setXYZ(k, velocity.x - u, velocity.y - v, velocity.z - w);
        spins.setXYZ(k, spin.x, spin.y, spin.z);
      });
      velocities.needsUpdate = spins.needsUpdate = true;
    });
    const {surface, uniforms} = this;
    this.heights.image.data.set(surface.heights);
    this.heights.needsUpdate = true;
    uniforms.u_corner.value.set(surface.x0 - origin[0], surface.y0 - origin[1]);
    uniforms.u_level.value = surface.level - origin[2];
  }
}

// The bar: the colours with their pressures in kPa, and striped ends where the run goes beyond.
export const pressureBar = (pressure) => {
  const rgb = colorsOf(pressure);
  const stops = Array.from({length: rgb.length / 3}, (_, i) => `rgb(${rgb.slice(3 * i, 3 * i + 3).join()})`);
  const bar = element("i", {className: "colors"});
  bar.style.background = `linear-gradient(to right, ${stops.join()})`;
  const ticks = pressure.ticks.map(({place, label}) => {
    const tick = element("span", {textContent: label.replace("-", "−")});
    tick.style.left = `${100 * place}%`;
    return tick;
  });
  const cap = (beyond, color, other) => {
    if (!beyond) return [];
    const node = element("i", {className: "cap", title: "beyond the scale"});
    node.style.background = `repeating-linear-gradient(135deg, ${color} 0 3px, ${other} 3px 6px)`;
    return [node];
  };
  const scale = element("div", {className: "scale"}, bar, ...ticks);
  return element("div", {id: "pressure", title: pressure.name}, "kPa",
                 ...cap(pressure.below, stops[0], "#000"), scale,
                 ...cap(pressure.above, stops[stops.length - 1], "#fff"));
};
