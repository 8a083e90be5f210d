// Reads an exported run with three.js, beside Khronos' validator.  node check_export.mjs FILE.glb TRAJECTORY.csv
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import validator from 'gltf-validator';
import {AnimationMixer, PropertyBinding, Vector3} from 'three';
import {GLTFLoader} from 'three/addons/loaders/GLTFLoader.js';

const bytes = readFileSync(process.argv[2]);
const report = await validator.validateBytes(new Uint8Array(bytes));
const faults = report.issues.messages.filter((message) => message.severity < 2);
assert.deepEqual(faults, [], 'the validator has errors or warnings');

// Rows of the log by body.
const tracks = {};
for (const line of readFileSync(process.argv[3], 'utf8').trim().split('\n').slice(1)) {
  const [time, body, ...numbers] = line.split(',');
  (tracks[body] ??= []).push([Number(time), ...numbers.map(Number)]);
}

const buffer = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);
const gltf = await new GLTFLoader().parseAsync(buffer, '');
const mixer = new AnimationMixer(gltf.scene);
mixer.clipAction(gltf.animations[0]).play();
const find = (name) => gltf.scene.getObjectByName(PropertyBinding.sanitizeNodeName(name));
const show = (time) => {
  mixer.setTime(time);
  gltf.scene.updateMatrixWorld(true);
};
// From the axes of glTF, which has y up, to the world's.
const in_world = (v) => new Vector3(v.x, -v.z, v.y);
const place = (name) => in_world(find(name).getWorldPosition(new Vector3()));

for (const body of ['left', 'right', 'twin'])
  for (const row of [0, 13, 47, 70]) {
    const [time, x, y, z, w, i, j, k] = tracks[body][row];
    show(time);
    assert.ok(place(body).distanceTo(new Vector3(x, y, z)) < 1e-5, `${body} at ${time} s`);
    // Where the body's x axis points.
    const ahead = in_world(new Vector3(1, 0, 0).transformDirection(find(body).matrixWorld));
    const expected = new Vector3(1 - 2 * (j * j + k * k), 2 * (i * j + w * k), 2 * (i * k - w * j));
    assert.ok(ahead.distanceTo(expected) < 1e-5, `${body} turns at ${time} s`);
  }
// Half way between two rows a place is half way.
const [before, after] = [tracks.left[20], tracks.left[21]];
show((before[0] + after[0]) / 2);
const middle = new Vector3(...[1, 2, 3].map((n) => (before[n] + after[n]) / 2));
assert.ok(place('left').distanceTo(middle) < 1e-5);

// The camera on a body stays where it stands on it; the one on shore stands still.
const cameras = gltf.cameras.map((camera) => camera.name);
assert.deepEqual(cameras.sort(), ['deck', 'shore']);
const on_body = (time) => {
  show(time);
  return find('right').worldToLocal(find('deck').getWorldPosition(new Vector3()));
};
assert.ok(on_body(0).distanceTo(on_body(1.2)) < 1e-4);
show(1.2);
assert.ok(place('shore').distanceTo(new Vector3(3, -5, 2)) < 1e-5);

// The water is a surface whose samples are blended: at a sample it has the heights of that one.
const water = find('water');
show(1);
const weights = water.morphTargetInfluences;
assert.ok(Math.abs(weights.reduce((sum, weight) => sum + weight, 0) - 1) < 1e-5);
let highest = 0;
for (let vertex = 0; vertex < water.geometry.attributes.position.count; ++vertex) {
  let height = water.geometry.attributes.position.getZ(vertex);
  water.geometry.morphAttributes.position.forEach((target, n) => (height += weights[n] * target.getZ(vertex)));
  highest = Math.max(highest, Math.abs(height));
}
assert.ok(Math.abs(highest - 0.15) < 0.002, `the highest wave is ${highest} m`);

// The rope joins its bodies.
const ends = (time) => {
  show(time);
  const rope = find('ropes[tow]');
  const position = new Vector3();
  const found = [];
  for (const vertex of [0, rope.geometry.attributes.position.count - 1]) {
    rope.getVertexPosition(vertex, position);
    found.push(in_world(position.applyMatrix4(rope.matrixWorld)));
  }
  return found;
};
const [first, last] = ends(1);
const anchor = (body, x) => in_world(new Vector3(x, 0, 0).applyMatrix4(find(body).matrixWorld));
assert.ok(Math.min(first.distanceTo(anchor('left', 0.5)), last.distanceTo(anchor('left', 0.5))) < 0.05);
assert.ok(Math.min(first.distanceTo(anchor('right', -0.5)), last.distanceTo(anchor('right', -0.5))) < 0.05);

// Bodies of one shape and colour share a mesh.
assert.equal(find('right').geometry, find('twin').geometry);
console.log(`${bytes.length} bytes, ${report.info.drawCallCount} meshes drawn, ` +
            `${gltf.animations[0].tracks.length} tracks`);
