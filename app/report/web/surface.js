// The water's surface, or a level ground, as a square that fades out at its rim.
import * as THREE from "three";
import {makeSea} from "./sea.js";

const COUNT = 97;       // points along a side, for waves and height fields
const FLAT_COUNT = 33;  // a level plane needs fewer: only its rim is shaded
const LINE_EVERY = 4;   // cells between the lines drawn on the surface

const fade = (u, v) => {
  const r = Math.hypot(u, v);
  return Math.min(1, Math.max(0, (1 - r) / 0.3));
};

export class Surface {
  // look: {color, line, opacity, order of drawing}
  constructor(water, half, look) {
    this.half = half;
    this.level = water.level;
    this.count = water.kind === "flat" ? FLAT_COUNT : COUNT;
    this.cell = 2 * half / (this.count - 1);
    this.sea = makeSea(water, this.count);
    this.heights = new Float64Array(this.count ** 2);
    this.positions = new Float32Array(3 * this.count ** 2);
    this.geometry = new THREE.BufferGeometry();
    this.geometry.setAttribute("position", new THREE.BufferAttribute(this.positions, 3));
    this.geometry.setIndex(this.faces());
    this.geometry.setAttribute("color", this.colors());
    this.lines = new THREE.BufferGeometry();
    this.lines.setAttribute("position", this.geometry.getAttribute("position"));
    this.lines.setAttribute("color", this.colors());
    this.lines.setIndex(this.segments());
    const surface = new THREE.Mesh(this.geometry, new THREE.MeshPhongMaterial({
      color: look.color, specular: 0x99bbcc, shininess: 70, vertexColors: true, transparent: true,
      opacity: look.opacity, depthWrite: false, side: THREE.DoubleSide}));
    const grid = new THREE.LineSegments(this.lines, new THREE.LineBasicMaterial({
      color: look.line, vertexColors: true, transparent: true, opacity: 0.28, depthWrite: false}));
    surface.renderOrder = look.order;
    grid.renderOrder = look.order + 1;
    surface.frustumCulled = grid.frustumCulled = false;
    this.group = new THREE.Group();
    this.group.add(surface, grid);
  }

  faces() {
    const index = [];
    for (let j = 0; j + 1 < this.count; ++j)
      for (let i = 0; i + 1 < this.count; ++i) {
        const a = j * this.count + i, b = a + 1, c = a + this.count, d = c + 1;
        index.push(a, b, d, a, d, c);
      }
    return index;
  }

  segments() {
    const index = [], last = this.count - 1;
    for (let k = 0; k <= last; k += LINE_EVERY)
      for (let i = 0; i < last; ++i)
        index.push(k * this.count + i, k * this.count + i + 1, i * this.count + k, (i + 1) * this.count + k);
    return index;
  }

  colors() {
    const colors = new Float32Array(4 * this.count ** 2).fill(1);
    const middle = (this.count - 1) / 2;
    for (let j = 0; j < this.count; ++j)
      for (let i = 0; i < this.count; ++i)
        colors[4 * (j * this.count + i) + 3] = fade((i - middle) / middle, (j - middle) / middle);
    return new THREE.BufferAttribute(colors, 4);
  }

  // The square about (x, y) in the world, to the nearest line, so that lines stay where they are.
  // origin: the world's place of the replay's (0, 0, 0).
  update(time, x, y, origin) {
    const step = LINE_EVERY * this.cell;
    const x0 = Math.round(x / step) * step - this.half, y0 = Math.round(y / step) * step - this.half;
    if (x0 !== this.x0 || y0 !== this.y0) this.sea.place(x0, y0, this.cell);
    this.x0 = x0;
    this.y0 = y0;
    this.sea.heights(time, this.heights);
    for (let j = 0, k = 0; j < this.count; ++j)
      for (let i = 0; i < this.count; ++i, ++k) {
        this.positions[3 * k] = x0 + i * this.cell - origin[0];
        this.positions[3 * k + 1] = y0 + j * this.cell - origin[1];
        this.positions[3 * k + 2] = this.level + this.heights[k] - origin[2];
      }
    this.geometry.getAttribute("position").needsUpdate = true;
    this.geometry.computeVertexNormals();
  }
}
