// node check_spectra.mjs: what of signals and spectra the page shows.
import assert from "node:assert/strict";
import {isLevel, peakOf, shownBins} from "../../app/report/web/spectra.js";

const signal = (min, max, unit = "m") => ({unit, statistics: {min, max}});

// What rounding leaves of a motion that is none is level, whatever its mean.
for (const level of [signal(0, 0), signal(-5e-7, 4e-7), signal(1000, 1000.0005), signal(0, 9e-6, "deg")])
  assert.ok(isLevel(level), JSON.stringify(level));
for (const moves of [signal(0, 1e-5), signal(1000, 1000.01), signal(0, 2e-5, "deg"), signal(0, 0.1, "N")])
  assert.ok(!isLevel(moves), JSON.stringify(moves));

// An axis ends behind the last density that is not small beside the largest of all lines.
const spectrum = (bins, peak, top) => Float32Array.from({length: bins}, (_, i) => i === peak ? top : 1e-6 * top);
assert.equal(shownBins([spectrum(100, 40, 2)]), 47);
assert.equal(shownBins([spectrum(100, 40, 2), spectrum(100, 80, 1e-3)]), 47);
assert.equal(shownBins([spectrum(100, 40, 2), spectrum(100, 80, 1)]), 93);
assert.equal(shownBins([spectrum(100, 1, 2)]), 8);
assert.equal(shownBins([spectrum(5, 4, 2)]), 5);

assert.equal(peakOf([[0, 2, 1], [null, 1, 3]]), 2);
assert.equal(peakOf([[null, null]]), 0);
