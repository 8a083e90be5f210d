// What of signals and spectra is worth showing.
import {LEAST} from "./extent.js";

const SMALL = 0.01;      // of the largest density in a plot: less does not widen its axis
const MARGIN = 1.15;     // of the axis over the last frequency that counts
const LEAST_BINS = 8;    // of an axis
const ROUNDING = 1e-6;   // of a value

export const unitOf = ({unit}) => unit === "deg" ? "°" : unit;

// What a run leaves of a motion that is none.
export const leastOf = (signal) => LEAST[unitOf(signal)] ?? 0;

// True if a signal does no more than that.
export const isLevel = (signal) => {
  const {min, max} = signal.statistics;
  return max - min <= Math.max(leastOf(signal), ROUNDING * Math.max(Math.abs(min), Math.abs(max)));
};

// The number of values of densities at multiples of one step that an axis shows.
export const shownBins = (densities, small = SMALL) => {
  const top = Math.max(...densities.map((d) => d.reduce((a, b) => Math.max(a, b), 0)));
  let last = 0;
  for (const density of densities)
    density.forEach((value, i) => { if (value >= small * top) last = Math.max(last, i); });
  const longest = Math.max(...densities.map((d) => d.length));
  return Math.min(Math.max(Math.ceil(MARGIN * last) + 1, LEAST_BINS), longest);
};

// The index of the largest of all values.
export const peakOf = (columns) => {
  let peak = 0, top = -Infinity;
  for (const column of columns)
    column.forEach((value, i) => { if (value !== null && value > top) [peak, top] = [i, value]; });
  return peak;
};
