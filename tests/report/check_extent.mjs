// node check_extent.mjs: how far a plot's lines reach, where a line has gaps.
import assert from "node:assert/strict";
import {largestOf, spreadOf} from "../../app/report/web/extent.js";

const chart = (...lines) => ({lines: lines.map((values) => ({values}))});

assert.equal(spreadOf(chart([1000, 1001, 1003])), 3);
assert.equal(spreadOf(chart([null, 1000, 1003, null], [-5, -4])), 3);
assert.equal(spreadOf(chart([null, null])), 0);
assert.equal(spreadOf(chart()), 0);
assert.equal(largestOf(chart([null, -1000, 3], [5])), 1000);
assert.equal(largestOf(chart([null])), 0);
// Beside a line of numbers as the page unpacks them.
assert.equal(spreadOf(chart(Float64Array.of(7, 7.5), [null, 8])), 0.5);
