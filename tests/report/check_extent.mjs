// node check_extent.mjs: how far a plot's lines reach, where a line has gaps.
import assert from "node:assert/strict";
import {flatBounds, largestOf, leastOf, spreadOf} from "../../app/report/web/extent.js";

const chart = (...lines) => ({lines: lines.map((values) => ({values}))});

assert.equal(spreadOf(chart([1000, 1001, 1003])), 3);
assert.equal(spreadOf(chart([null, 1000, 1003, null], [-5, -4])), 3);
assert.equal(spreadOf(chart([null, null])), 0);
assert.equal(spreadOf(chart()), 0);
assert.equal(largestOf(chart([null, -1000, 3], [5])), 1000);
assert.equal(largestOf(chart([null])), 0);
// Beside a line of numbers as the page unpacks them.
assert.equal(spreadOf(chart(Float64Array.of(7, 7.5), [null, 8])), 0.5);

// A constant with noise is a level line: the noise takes less than a fiftieth of the axis.
for (const [middle, noise, least] of [[1000, 1e-6], [0, 1e-10], [5e-13, 5e-13], [-3, 2e-9], [0, 4e-7, 1e-6]]) {
  const line = {...chart([middle - noise, middle, middle + noise]), least};
  const bounds = flatBounds(middle - noise, middle + noise, leastOf(line));
  assert.ok(bounds !== null && 2 * noise < 0.02 * (bounds[1] - bounds[0]), `${middle} ± ${noise}: ${bounds}`);
  assert.ok(bounds[0] < middle && middle < bounds[1]);
}
// What changes is not.
for (const [low, high, least] of [[0, 1e-3], [1000, 1000.01], [0, 2e-9], [0, 2e-6, 1e-6]])
  assert.equal(flatBounds(low, high, leastOf({...chart([low, high]), least})), null, `${low} … ${high}`);
