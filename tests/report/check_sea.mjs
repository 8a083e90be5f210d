// node check_sea.mjs: the replay's water against the sums of hydro/sea.h, term by term.
import assert from "node:assert/strict";
import {makeSea} from "../../app/report/web/sea.js";

const COUNT = 7, CELL = 0.5, X0 = -1.25, Y0 = 40.5, TIME = 3.7;
const out = new Float64Array(COUNT * COUNT);
const check = (sea, expected) => {
  sea.place(X0, Y0, CELL);
  sea.heights(TIME, out);
  for (let j = 0; j < COUNT; ++j)
    for (let i = 0; i < COUNT; ++i) {
      const error = out[j * COUNT + i] - expected(X0 + i * CELL, Y0 + j * CELL);
      assert.ok(Math.abs(error) < 1e-12, `height off by ${error} m`);
    }
};

// Three waves; of the last one the grid has less than two points, and leaves it out.
const waves = [[0.3, 0.5, -0.2, 2.2, 0.4], [0.1, -1.1, 0.7, 3.6, -2]];
const short = [0.2, 9, 0, 9.4, 0];
check(makeSea({kind: "waves", components: Float64Array.from([...waves, short].flat()), ramp: 0}, COUNT), (x, y) =>
  waves.reduce((h, [a, kx, ky, omega, phase]) => h + a * Math.cos(kx * x + ky * y - omega * TIME + phase), 0));

// In a ramp of twice the time the amplitudes are half of theirs.
check(makeSea({kind: "waves", components: Float64Array.from(waves.flat()), ramp: 2 * TIME}, COUNT), (x, y) =>
  waves.reduce((h, [a, kx, ky, omega, phase]) => h + a / 2 * Math.cos(kx * x + ky * y - omega * TIME + phase), 0));

check(makeSea({kind: "flat"}, COUNT), () => 0);

// 2 × 3 heights of a bilinear function, which their interpolation has; beyond them the nearest edge.
const plane = (x, y) => 0.1 + 0.2 * x - 0.3 * y + 0.05 * x * y;
const origin = [-1, 41], cell = 1.5, rows = 2, columns = 3;
const heights = Array.from({length: rows * columns}, (_, k) =>
  plane(origin[0] + cell * (k % columns), origin[1] + cell * Math.floor(k / columns)));
const clamp = (s, low, high) => Math.min(Math.max(s, low), high);
check(makeSea({kind: "heightfield", rows, columns, cell, origin, heights}, COUNT), (x, y) =>
  plane(clamp(x, origin[0], origin[0] + cell * (columns - 1)), clamp(y, origin[1], origin[1] + cell * (rows - 1))));
