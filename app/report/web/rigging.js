// Lines, anchors and machines of the replay (page_rigging.cpp).
import * as THREE from "three";
import {LineMaterial} from "three/addons/lines/LineMaterial.js";
import {LineSegments2} from "three/addons/lines/LineSegments2.js";
import {LineSegmentsGeometry} from "three/addons/lines/LineSegmentsGeometry.js";
import {rowAt} from "./data.js";
import {coil, hanging, lineShape, pathShape, tensionColor} from "./line_shapes.js";

const WIDTH = 2.6;     // px of a line
const SPRING = 1.6;    // px of a spring's wire
const BROKEN = [0.16, 0.15, 0.15];
const WORLD = -1;

// Row before a time, and how far the time is to the next one.
const between = (times, time) => {
  const row = Math.min(rowAt(times, time), Math.max(times.length - 2, 0));
  const next = Math.min(row + 1, times.length - 1);
  const part = next === row ? 0 : (time - times[row]) / (times[next] - times[row]);
  return {row, next, part: Math.min(Math.max(part, 0), 1)};
};
const mixed = (column, {row, next, part}) => column[row] + part * (column[next] - column[row]);

const wire = (points, width) => {
  const geometry = new LineSegmentsGeometry();
  geometry.setPositions(new Float32Array(6 * (points - 1)));
  const line = new LineSegments2(geometry, new LineMaterial({linewidth: width}));
  line.frustumCulled = false;
  return line;
};

// Puts a line of segments through points.
const place = (line, points) => {
  const {data} = line.geometry.attributes.instanceStart;
  for (let i = 0; i + 3 < points.length; i += 3)
    for (let k = 0; k < 6; ++k) data.array[2 * i + k] = points[i + k];
  data.needsUpdate = true;
};

const paint = (line, color) => line.material.color.setRGB(...color, THREE.SRGBColorSpace);

export class Rigging {
  // pose(body, time, position, orientation) tells where a body is; geometryOf makes what is drawn of
  // a mesh; ghost {color, looks, order} is the look of all of it in a second run.
  constructor(rigging, pose, geometryOf, ghost = null) {
    this.rigging = rigging;
    this.pose = pose;
    this.ghost = ghost;
    this.group = new THREE.Group();
    this.lines = rigging.lines.map((line) => {
      const count = line.coil ? coil([0, 0, 0], [0, 0, 1], line.coil).length / 3 : rigging.points;
      const made = {whole: wire(count, line.coil ? SPRING : WIDTH),
                    rests: [wire(2, WIDTH), wire(2, WIDTH)]};
      for (const rest of made.rests) paint(rest, BROKEN);
      if (ghost) [made.whole, ...made.rests].forEach((wires) => this.makeGhostly(wires));
      this.group.add(made.whole, ...made.rests);
      return made;
    });
    this.parts = rigging.parts.map((part) => {
      const mesh = new THREE.Mesh(geometryOf(part.mesh), new THREE.MeshStandardMaterial({
        color: ghost?.color ?? new THREE.Color().setRGB(...part.color, THREE.SRGBColorSpace),
        roughness: 0.55, metalness: 0.1, ...ghost?.looks}));
      mesh.frustumCulled = false;
      if (ghost) mesh.renderOrder = ghost.order;
      this.group.add(mesh);
      return mesh;
    });
  }

  makeGhostly(wires) {
    const {color, looks: {opacity}, order} = this.ghost;
    wires.material.color.copy(color);
    Object.assign(wires.material, {transparent: true, opacity, depthWrite: false});
    wires.renderOrder = order;
  }

  // Gives a line the colour of its tension.
  paintTension(wires, tension, now) {
    if (!this.ghost) paint(wires, tensionColor(this.rigging.tensions, mixed(tension, now)));
  }

  // A body's place and turn; the world's are those of the replay.
  frame(body, time) {
    const position = new THREE.Vector3(), orientation = new THREE.Quaternion();
    if (body !== WORLD) this.pose(body, time, position, orientation);
    return {position, orientation};
  }

  endOf({body, at}, time) {
    const {position, orientation} = this.frame(body, time);
    return new THREE.Vector3(...at).applyQuaternion(orientation).add(position).toArray();
  }

  update(time) {
    const now = between(this.rigging.times, time);
    this.rigging.lines.forEach((line, i) => this.updateLine(line, this.lines[i], time, now));
    this.rigging.parts.forEach((part, i) => {
      const {position, orientation} = this.frame(part.body, time);
      const mesh = this.parts[i];
      mesh.position.set(...part.at).applyQuaternion(orientation).add(position);
      mesh.quaternion.copy(orientation);
      for (const {axis, angle} of part.turns)
        mesh.quaternion.multiply(new THREE.Quaternion().setFromAxisAngle(
          new THREE.Vector3(...axis), mixed(angle, now)));
    });
  }

  updateLine(line, {whole, rests}, time, now) {
    const {points} = this.rigging;
    const [first, second] = line.ends.map((end) => this.endOf(end, time));
    const broken = line.broken[now.part < 1 ? now.row : now.next] !== 0;
    whole.visible = !broken;
    rests.forEach((rest, i) => { rest.visible = broken && line.ends[i].body !== WORLD; });
    if (broken) {
      place(rests[0], hanging(first, line.hanging));
      place(rests[1], hanging(second, line.hanging));
      return;
    }
    place(whole, line.coil ? coil(first, second, line.coil)
      : line.path ? pathShape(line.path, points, now)
      : lineShape(first, second, line.shape, points, now));
    this.paintTension(whole, line.tension, now);
  }
}
