// node check_rig.mjs: which plots of lines, joints, machines and controls a body has, and its track.
import assert from "node:assert/strict";
import {courseOf, rigOf} from "../../app/report/web/rig.js";
import {fitted, isLong, roundStep} from "../../app/report/web/track.js";

const nothing = {lines: [], joints: [], propellers: [], foils: [], controls: []};

// A body that turns by 30° a second from 170°, through where atan2 jumps, and runs along x.
const times = [0, 1, 2, 3];
const pose = (i) => {
  const half = (170 + 30 * i) * Math.PI / 360;
  return [10 * i, i, 0, 0, 0, Math.sin(half), Math.cos(half)];
};
const runOf = (rig) => ({
  origin: [100, 200, 0],
  poses: {times, tracks: [Float32Array.from(times.flatMap(pose)), new Float32Array(28)]},
  series: {times, rig: {...nothing, ...rig}}});
const titles = (groups) => groups.map(({title}) => title);
const labels = (chart) => chart.lines.map(({label}) => label);
const at = (groups, group, chart) =>
  groups.find(({title}) => title === group).charts.find(({title}) => title === chart);

const rope = {name: "ropes[a]", bodies: [0, 1], broken_at: 1,
              columns: {tension: [1, 2, 0, 0], distance: [5, 5, 5, 5], length: [4, 4, 4, 4]}};
const mooring = {name: "moorings[b]", bodies: [1], broken_at: null,
                 columns: {...rope.columns, length: [4, 4, 4, 3], resting: [1, 1, 1, 1]}};
const hinge = {name: "h", type: "hinge", bodies: [1],
               columns: {force: [1, 1, 1, 1], coordinate: [0, 1, 2, 3], speed: [1, 1, 1, 1], effort: [0, 0, 0, 0]}};
const rudder = {name: "rudders[r]", bodies: [0], fluid: "water",
                columns: {angle: [1, 2, 3, 4], attack: [0, 0, 0, 0], flow: [1, 1, 1, 1], force: [1, 1, 1, 1]}};
const control = {name: "rudders[r].angle_deg", columns: {value: [1, 2, 3, 4]}};
const run = runOf({lines: [rope, mooring], joints: [hinge], foils: [rudder], controls: [control]});

// A body has what is fastened to it, and every control.
const first = rigOf(run, 0), second = rigOf(run, 1);
assert.deepEqual(titles(first), ["Lines", "Machines", "Controls"]);
assert.deepEqual(titles(second), ["Lines", "Joints", "Controls"]);
assert.deepEqual(labels(at(first, "Lines", "Tension")), ["ropes[a]"]);
assert.deepEqual(labels(at(second, "Lines", "Tension")), ["ropes[a]", "moorings[b]"]);
assert.deepEqual(titles(rigOf(runOf({}), 0)), []);

// Breaks are marked, and the lengths that a winch changes are beside the distances.
assert.deepEqual(at(first, "Lines", "Tension").moments, [{time: 1, text: "ropes[a] breaks"}]);
assert.equal(at(first, "Lines", "Tension").note, "ropes[a] breaks at 1 s");
assert.deepEqual(labels(at(second, "Lines", "Distance of the ends")),
                 ["ropes[a]", "moorings[b]", "moorings[b], unstretched"]);
assert.deepEqual(labels(at(second, "Lines", "Length on the bottom")), ["moorings[b]"]);

// What never acts has no plot; the unit of a set point is that of its name.
assert.equal(at(second, "Joints", "Effort along hinges"), undefined);
assert.deepEqual(labels(at(second, "Joints", "Angle of hinges")), ["h"]);
assert.equal(at(first, "Controls", "Angle").unit, "°");

// Only a body with machines has a course: its way in the world, and a heading without jumps.
assert.deepEqual(courseOf(run, 1, {yaw: []}), []);
const [{charts: [track, heading]}] = courseOf(run, 0, {yaw: [170, 200, 230, 260]});
assert.deepEqual(track.track.x, [100, 110, 120, 130]);
assert.deepEqual(track.track.y, [200, 201, 202, 203]);
track.track.heading.forEach((degrees, i) => assert.ok(Math.abs(degrees - 170 - 30 * i) < 1e-4));
assert.deepEqual(labels(heading), ["heading", "rudders[r]"]);
assert.ok(track.wide && heading.wide);
assert.ok(!isLong({x: [0, 2], y: [0, 1]}));

// One scale for both axes, y upwards, all of the way inside; also where the body does not move.
for (const [x, y] of [[[0, 100], [0, 10]], [[0, 1], [0, 900]], [[5, 5], [7, 7]]]) {
  const map = fitted(x, y, 300, 200);
  assert.ok(Number.isFinite(map.scale));
  assert.ok(Math.abs(map.x(x[0] + 1) - map.x(x[0]) - map.scale) < 1e-9);
  assert.ok(Math.abs(map.y(y[0]) - map.y(y[0] + 1) - map.scale) < 1e-9);
  for (const value of x) assert.ok(map.x(value) >= 0 && map.x(value) <= 300);
  for (const value of y) assert.ok(map.y(value) >= 0 && map.y(value) <= 200);
  assert.ok(Math.abs(map.x(map.range[0][1]) - 300) < 1e-9);
}
assert.deepEqual([0.11, 1, 2.1, 49, 51].map(roundStep), [0.2, 1, 5, 50, 100]);
