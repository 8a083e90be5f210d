// node check_lines.mjs: shapes and colours of lines in the replay.
import assert from "node:assert/strict";
import {coil, hanging, lineShape, pathShape, tensionColor} from "../../app/report/web/line_shapes.js";

const near = (a, b, tolerance = 1e-6) =>
  assert.ok(Math.abs(a - b) <= tolerance, `${a} is not near ${b}`);
const now = {row: 0, next: 1, part: 0.25};

// A straight line has its points on its chord.
const straight = lineShape([0, 0, 0], [4, 8, -4], null, 5, now);
assert.deepEqual([...straight.slice(6, 9)], [2, 4, -2]);

// Three points, of which the inner one lies 1 and 5 below the chord in two rows.
const bent = lineShape([0, 0, 0], [2, 0, 0], [0, 0, -1, 0, 0, -5], 3, now);
assert.deepEqual([...bent], [0, 0, 0, 1, 0, -2, 2, 0, 0]);

// Two points that move between two rows.
assert.deepEqual([...pathShape([0, 0, 0, 4, 0, 0, 0, 0, 8, 4, 4, 0], 2, now)], [0, 0, 2, 4, 1, 0]);

// A coil keeps its ends and lies on its cylinder, also where it stands upright.
for (const end of [[3, 4, 0], [0, 0, 5], [0, 0, 0]]) {
  const points = coil([0, 0, 0], end, {radius: 0.5, turns: 4});
  assert.deepEqual(points.slice(0, 3), [0, 0, 0]);
  assert.deepEqual(points.slice(-3), end);
  const length = Math.hypot(...end);
  for (let i = 6; i < points.length - 6; i += 3) {
    const p = points.slice(i, i + 3);
    const along = length > 0 ? p.reduce((sum, x, k) => sum + x * end[k] / length, 0) : 0;
    near(Math.hypot(...p) ** 2 - along ** 2, 0.25);
  }
}

assert.deepEqual(hanging([1, 2, 3], 2), [1, 2, 3, 1, 2, 1]);

const scale = {top: 100, colors: [[0.5, 0.5, 0.5], [0, 1, 0], [1, 1, 0], [1, 0, 0]], push: [0, 0, 1]};
assert.deepEqual(tensionColor(scale, 0), [0.5, 0.5, 0.5]);
assert.deepEqual(tensionColor(scale, 1e3), [1, 0, 0]);
assert.deepEqual(tensionColor(scale, -1e3), [0, 0, 1]);
near(tensionColor(scale, 50)[0], 0.5);
assert.deepEqual(tensionColor({...scale, top: 0}, 5), [0.5, 0.5, 0.5]);
