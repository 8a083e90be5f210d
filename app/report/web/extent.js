// How far the numbers of a plot's lines reach. Where a line has none they are null.

// How far the line that changes most does so.
export const spreadOf = ({lines}) => {
  let spread = 0;
  for (const {values} of lines) {
    let low = Infinity, high = -Infinity;
    for (const value of values) {
      if (value === null) continue;
      low = Math.min(low, value);
      high = Math.max(high, value);
    }
    spread = Math.max(spread, high - low);
  }
  return spread;
};

export const largestOf = ({lines}) => {
  let largest = 0;
  for (const {values} of lines)
    for (const value of values) if (value !== null) largest = Math.max(largest, Math.abs(value));
  return largest;
};

// What a run leaves of a motion that is none, by its unit.
export const LEAST = {"m": 1e-6, "°": 1e-5, "m/s": 1e-6, "rad/s": 1e-7};

const ROUNDING = 1e-6;  // of a number: smaller changes are those of its last digits
const TINY = 1e-9;      // of a chart that names no least change
const FLAT = 50;        // how much farther than rounding the axis of a constant reaches, each way

// The change below which the lines of a chart are constant but for rounding: that of its largest
// number, or the chart's own `least`.
export const leastOf = (chart) => Math.max(ROUNDING * largestOf(chart), chart.least ?? TINY);

// The axis on which what changes by less than `least` is a level line; null for what changes.
export const flatBounds = (low, high, least) => {
  if (high - low >= least) return null;
  const middle = (low + high) / 2, half = Math.max(0.1 * Math.abs(middle), FLAT * least);
  return [middle - half, middle + half];
};
