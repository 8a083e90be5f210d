// The bodies and the water in three dimensions, at the clock's time.
import * as THREE from "three";
import {OrbitControls} from "three/addons/controls/OrbitControls.js";
import {toCreasedNormals} from "three/addons/utils/BufferGeometryUtils.js";
import {Backdrop} from "./backdrop.js";
import {floats, integers, rowAt} from "./data.js";
import {Pressure} from "./pressure.js";
import {Rigging} from "./rigging.js";
import {Surface} from "./surface.js";

const CREASE = 40 * Math.PI / 180;  // edges that turn by more stay sharp, as in the pictures
const POSE = 7;                     // numbers a row: position, quaternion x y z w
const SAMPLES = 200;                // rows from which the extent of the motion is taken
const CLICK = 4;                    // px that the mouse may move in a click
const WIDTH_TO_HEIGHT = 4 / 3;      // of a picture
const FIELD_OF_VIEW = 35;           // degrees, of a scene without a camera
const GHOST = 0.55;                 // opacity of the bodies of a second run
const GHOST_ORDER = 2.4;            // of drawing: after the water

const geometryOf = (mesh) => {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(floats(mesh.vertices), 3));
  geometry.setIndex(new THREE.BufferAttribute(integers(mesh.triangles), 1));
  const creased = toCreasedNormals(geometry, CREASE);
  creased.computeBoundingSphere();
  return creased;
};

// Position and orientation of a body at a time, between the two rows around it.
const poseIn = ({times, tracks}, body, time, position, orientation) => {
  const row = Math.min(rowAt(times, time), Math.max(times.length - 2, 0));
  const next = Math.min(row + 1, times.length - 1);
  const part = next === row ? 0
    : Math.min(Math.max((time - times[row]) / (times[next] - times[row]), 0), 1);
  const a = tracks[body], i = POSE * row, j = POSE * next;
  position.set(a[i], a[i + 1], a[i + 2]).lerp(spare.set(a[j], a[j + 1], a[j + 2]), part);
  orientation.set(a[i + 3], a[i + 4], a[i + 5], a[i + 6])
    .slerp(turn.set(a[j + 3], a[j + 4], a[j + 5], a[j + 6]), part);
};
const spare = new THREE.Vector3(), turn = new THREE.Quaternion();

// The places of a body as points of a path.
const pathOf = (track, rows) => {
  const points = new Float32Array(3 * rows);
  for (let row = 0; row < rows; ++row) points.set(track.subarray(POSE * row, POSE * row + 3), 3 * row);
  return points;
};

export class Replay {
  // @param other   {run, color}: a second run, whose bodies, lines and machines are drawn over those
  //     of the first one, translucent and of this colour.
  constructor(run, clock, canvas, label, look, other = null) {
    this.run = run;
    this.other = other;
    this.clock = clock;
    this.canvas = canvas;
    this.label = label;
    this.origin = run.origin;
    this.selected = 0;
    this.following = false;
    this.onSelect = () => {};
    this.renderer = new THREE.WebGLRenderer({canvas, antialias: true, alpha: true});
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.scene = new THREE.Scene();
    this.addLights();
    this.addBodies();
    this.addRigging();
    this.measure();
    this.addGround(look);
    if (run.water) {
      this.water = new Surface(run.water, this.half,
                               {color: look.water, line: look.waterLine, opacity: 0.66, order: 1});
      this.backdrop = new Backdrop(look.water, run.water.level - this.origin[2], this.half);
      this.water.group.add(this.backdrop.mesh);
      this.scene.add(this.water.group);
    }
    if (run.pressure) {
      this.pressure = new Pressure(run.pressure, this.meshes, this.water, this.renderer.getPixelRatio());
      this.scene.add(this.pressure.group);
    }
    this.addMarks(look);
    this.addCamera();
    clock.onChange(() => this.wake());
    new ResizeObserver(() => this.fit()).observe(canvas.parentElement);
    this.fit();
  }

  addLights() {
    this.scene.add(new THREE.HemisphereLight(0xffffff, 0x6b7a8a, 1.9));
    const sun = new THREE.DirectionalLight(0xffffff, 2.2);
    sun.position.set(-0.4, -0.6, 1);
    this.scene.add(sun);
  }

  addBodies() {
    this.radius = [];
    Object.assign(this, this.bodiesOf(this.run, {}, this.radius));
    if (!this.other) return;
    // Where both runs agree, the solid bodies are seen.
    const color = new THREE.Color(this.other.color);
    // They shine, so that their colour is seen through the water, too.
    const looks = {transparent: true, opacity: GHOST, depthWrite: false, emissive: color, emissiveIntensity: 0.7,
                   polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1};
    this.ghost = {color, looks, order: GHOST_ORDER};
    this.ghosts = this.bodiesOf(this.other.run, looks, [], color);
    for (const mesh of this.ghosts.meshes) mesh.renderOrder = GHOST_ORDER;
  }

  // Lines and machines of both runs, which are shown and hidden together.
  addRigging() {
    this.riggings = [{run: this.run}, {run: this.other?.run, ghost: this.ghost}]
      .filter(({run}) => run?.rigging)
      .map(({run, ghost}) => new Rigging(run.rigging, (...where) => poseIn(run.poses, ...where), geometryOf, ghost));
    this.rigging = new THREE.Group();
    for (const {group} of this.riggings) this.rigging.add(group);
    this.scene.add(this.rigging);
  }

  // Bodies of one shape are drawn at once.
  // @param looks    Of their material, beyond that of all bodies.
  // @param radius   Filled with how far each reaches from its centre.
  // @param color    Of all of them; none: each has its own.
  // @return the meshes, and of each body its mesh and its index there
  bodiesOf({bodies, shapes}, looks, radius, color = null) {
    const own = (body) => new THREE.Color().setRGB(...bodies[body].color, THREE.SRGBColorSpace);
    const places = [];
    const members = shapes.map(() => []);
    bodies.forEach((body, i) => members[body.shape].push(i));
    const meshes = members.map((list, shape) => {
      const geometry = geometryOf(shapes[shape]);
      const mesh = new THREE.InstancedMesh(
        geometry, new THREE.MeshStandardMaterial({roughness: 0.62, metalness: 0.05, ...looks}), list.length);
      mesh.frustumCulled = false;
      const {center, radius: reach} = geometry.boundingSphere;
      list.forEach((body, k) => {
        mesh.setColorAt(k, color ?? own(body));
        places[body] = {mesh, index: k};
        radius[body] = center.length() + reach;
      });
      mesh.bodies = list;
      this.scene.add(mesh);
      return mesh;
    });
    return {meshes, places};
  }

  rows() { return this.run.poses.times.length; }

  pose(body, time, position, orientation) { poseIn(this.run.poses, body, time, position, orientation); }

  // Velocity and spin of a body at a time, from the two rows around it.
  motion(body, time) {
    const {times, tracks} = this.run.poses;
    const velocity = new THREE.Vector3(), spin = new THREE.Vector3();
    const row = Math.min(rowAt(times, time), times.length - 2);
    if (row < 0) return {velocity, spin};
    const span = times[row + 1] - times[row], track = tracks[body];
    const [i, j] = [POSE * row, POSE * (row + 1)];
    velocity.fromArray(track, j).sub(spare.fromArray(track, i)).divideScalar(span);
    const before = new THREE.Quaternion().fromArray(track, i + 3);
    const turned = new THREE.Quaternion().fromArray(track, j + 3).multiply(before.invert());
    const sine = Math.hypot(turned.x, turned.y, turned.z);
    const angle = 2 * Math.atan2(sine, Math.abs(turned.w));
    if (sine > 0) spin.set(turned.x, turned.y, turned.z).multiplyScalar(Math.sign(turned.w) * angle / (sine * span));
    return {velocity, spin};
  }

  // The middle of all bodies in a row, and how far they reach from it.
  extent(row) {
    const {tracks} = this.run.poses;
    const box = new THREE.Box3();
    tracks.forEach((track, body) => {
      const p = new THREE.Vector3().fromArray(track, POSE * row);
      box.expandByPoint(p.clone().addScalar(this.radius[body]));
      box.expandByPoint(p.addScalar(-this.radius[body]));
    });
    const size = box.getSize(new THREE.Vector3());
    return {middle: box.getCenter(new THREE.Vector3()), reach: Math.hypot(size.x, size.y) / 2, box};
  }

  // How large the shown part of the world is, and whether it must go with the bodies.
  measure() {
    const rows = this.rows(), stride = Math.max(1, Math.floor(rows / SAMPLES));
    let reach = 0, drift = 0;
    const all = new THREE.Box3();
    const first = this.extent(0);
    for (let row = 0; row < rows; row += stride) {
      const {middle, reach: r, box} = this.extent(row);
      reach = Math.max(reach, r);
      drift = Math.max(drift, Math.hypot(middle.x - first.middle.x, middle.y - first.middle.y));
      all.union(box);
    }
    this.first = first;
    this.lowest = all.min.z;
    const {camera} = this.run;
    const view = camera ? Math.hypot(...camera.from.map((c, i) => c - camera.to[i])) : 0;
    this.half = Math.max(3.5 * reach, 0.9 * view);
    this.drifts = drift > 1.2 * reach;
    this.following = this.drifts;
  }

  addGround(look) {
    const {ground} = this.run;
    if (!ground) return;
    const material = new THREE.MeshStandardMaterial({color: look.ground, roughness: 1, side: THREE.DoubleSide});
    if (ground.mesh) {
      const mesh = new THREE.Mesh(geometryOf(ground.mesh), material);
      mesh.position.set(...ground.origin.map((c, i) => c - this.origin[i]));
      this.scene.add(mesh);
      return;
    }
    const floor = {kind: "flat", level: ground.z};
    const looks = {color: look.ground, line: look.groundLine, opacity: 1, order: -2};
    this.ground = new Surface(floor, this.half, looks);
    this.scene.add(this.ground.group);
  }

  // Axes and path of the selected body.
  addMarks(look) {
    this.axes = new THREE.AxesHelper(1);
    this.axes.material.depthTest = false;
    this.axes.renderOrder = 4;
    const pathIn = (color) => {
      const path = new THREE.Line(new THREE.BufferGeometry(), new THREE.LineBasicMaterial({
        color, transparent: true, opacity: 0.9, depthTest: false}));
      path.renderOrder = 3;
      path.frustumCulled = false;
      return path;
    };
    this.path = pathIn(look.path);
    this.ghostPath = pathIn(this.other?.color ?? look.path);
    this.path.add(this.ghostPath);  // shown and hidden with it
    this.scene.add(this.axes, this.path);
  }

  addCamera() {
    this.camera = new THREE.PerspectiveCamera(FIELD_OF_VIEW, 1, 1, 10);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.addEventListener("change", () => this.wake());
    let down;
    this.canvas.addEventListener("pointerdown", (event) => { down = [event.clientX, event.clientY]; });
    this.canvas.addEventListener("pointerup", (event) => {
      if (down && Math.hypot(event.clientX - down[0], event.clientY - down[1]) < CLICK) this.pick(event);
    });
    this.look("scene");
  }

  // A place of the world as the replay has it.
  local(p) { return new THREE.Vector3(...p.map((c, i) => c - this.origin[i])); }

  // Puts the camera where the scene has it, or above, or to a side of the bodies.
  look(view) {
    const {camera} = this.run;
    const target = this.first.middle.clone();
    const size = 1.15 * Math.max(this.first.reach, this.first.box.getSize(new THREE.Vector3()).z / 2);
    const away = size / Math.tan(FIELD_OF_VIEW / 2 * Math.PI / 180);
    const directions = {top: [0, -1e-3, 1], side: [0, -1, 0.02], front: [1, 0, 0.02], scene: [0.55, -0.75, 0.35]};
    let from = new THREE.Vector3(...directions[view]).normalize().multiplyScalar(away).add(target);
    this.fieldOfView = FIELD_OF_VIEW * Math.PI / 180;
    if (view === "scene" && camera) {
      from = this.local(camera.from);
      target.copy(this.local(camera.to));
      this.fieldOfView = camera.field_of_view;
    }
    const offset = this.following && this.at ? this.at.clone().sub(this.anchorAtStart()) : new THREE.Vector3();
    this.camera.position.copy(from).add(offset);
    this.controls.target.copy(target).add(offset);
    const distance = from.distanceTo(target);
    this.camera.near = distance / 200;
    this.camera.far = distance * 20 + 10 * this.half;
    this.frame();
    this.controls.update();
    this.wake();
  }

  // In a canvas that is narrower than a picture of 4:3 just as much is seen from side to side.
  frame() {
    const half = Math.tan(this.fieldOfView / 2) * Math.max(1, WIDTH_TO_HEIGHT / this.camera.aspect);
    this.camera.fov = 2 * Math.atan(half) * 180 / Math.PI;
    this.camera.updateProjectionMatrix();
  }

  follow(on) { this.following = on; this.at = null; this.wake(); }

  select(body) {
    this.selected = body;
    const show = (path, poses, of) => {
      path.geometry.dispose();
      path.geometry = new THREE.BufferGeometry();
      if (of >= 0)
        path.geometry.setAttribute("position",
                                   new THREE.BufferAttribute(pathOf(poses.tracks[of], poses.times.length), 3));
    };
    show(this.path, this.run.poses, body);
    if (this.other) {
      const {name} = this.run.bodies[body];
      const same = this.other.run.bodies.findIndex((one) => one.name === name);
      show(this.ghostPath, this.other.run.poses, same);
    }
    this.axes.scale.setScalar(1.25 * this.radius[body]);
    this.at = null;
    this.wake();
  }

  pick(event) {
    const box = this.canvas.getBoundingClientRect();
    const ray = new THREE.Raycaster();
    ray.setFromCamera(new THREE.Vector2(2 * (event.clientX - box.left) / box.width - 1,
                                        1 - 2 * (event.clientY - box.top) / box.height), this.camera);
    const [hit] = ray.intersectObjects(this.meshes, false);
    if (hit) this.onSelect(hit.object.bodies[hit.instanceId]);
  }

  fit() {
    const {clientWidth, clientHeight} = this.canvas.parentElement;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.camera.aspect = clientWidth / clientHeight;
    this.frame();
    this.draw();  // A canvas of a new size is empty, and would be shown so.
  }

  // Draws once before the browser shows its next picture.
  wake() {
    if (this.awake) return;
    this.awake = true;
    requestAnimationFrame(() => { this.awake = false; this.draw(); });
  }

  anchorAtStart() {
    const place = new THREE.Vector3();
    this.pose(this.selected, this.clock.start, place, new THREE.Quaternion());
    return place;
  }

  // Moves the camera with the selected body, but not up and down with the waves.
  carryCamera(place) {
    if (this.following) {
      const moved = this.at ? place.clone().sub(this.at) : new THREE.Vector3();
      moved.z = 0;
      this.camera.position.add(moved);
      this.controls.target.add(moved);
    }
    this.at = place.clone();
  }

  draw() {
    const {time} = this.clock;
    const position = new THREE.Vector3(), orientation = new THREE.Quaternion();
    const matrix = new THREE.Matrix4(), one = new THREE.Vector3(1, 1, 1);
    const middle = new THREE.Vector3();
    this.places.forEach(({mesh, index}, body) => {
      this.pose(body, time, position, orientation);
      middle.addScaledVector(position, 1 / this.places.length);
      mesh.setMatrixAt(index, matrix.compose(position, orientation, one));
      if (body === this.selected) {
        this.axes.position.copy(position);
        this.axes.quaternion.copy(orientation);
      }
    });
    this.ghosts?.places.forEach(({mesh, index}, body) => {
      poseIn(this.other.run.poses, body, time, position, orientation);
      mesh.setMatrixAt(index, matrix.compose(position, orientation, one));
    });
    for (const mesh of [...this.meshes, ...this.ghosts?.meshes ?? []]) {
      mesh.instanceMatrix.needsUpdate = true;
      mesh.boundingSphere = null;  // found anew when a click asks for it
    }
    for (const rigging of this.riggings) rigging.update(time);
    this.carryCamera(this.axes.position);
    const shown = this.drifts ? middle : this.first.middle;
    for (const surface of [this.water, this.ground])
      surface?.update(time, shown.x + this.origin[0], shown.y + this.origin[1], this.origin);
    this.pressure?.update((body) => this.motion(body, time), this.meshes, this.origin);
    this.backdrop?.update(this.camera);
    this.path.geometry.setDrawRange(0, rowAt(this.run.poses.times, time) + 1);
    if (this.other) this.ghostPath.geometry.setDrawRange(0, rowAt(this.other.run.poses.times, time) + 1);
    this.renderer.render(this.scene, this.camera);
    this.placeLabel();
  }

  // The name stands beside the selected body.
  placeLabel() {
    const {clientWidth, clientHeight} = this.canvas;
    const p = this.axes.position.clone().project(this.camera);
    const x = (1 + p.x) / 2 * clientWidth + 8, y = (1 - p.y) / 2 * clientHeight + 8;
    const inside = Math.abs(p.x) < 1 && Math.abs(p.y) < 1 && p.z < 1;
    this.label.style.transform = inside ? `translate(${x}px, ${y}px)` : "translate(8px, 8px)";
  }
}
