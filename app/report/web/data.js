// The run as the program has written it into the page (page_data.h).

const bytes = (base64) => {
  const text = atob(base64);
  const array = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) array[i] = text.charCodeAt(i);
  return array.buffer;
};

export const octets = (base64) => new Uint8Array(bytes(base64));
export const floats = (base64) => new Float32Array(bytes(base64));
export const doubles = (base64) => new Float64Array(bytes(base64));
export const integers = (base64) => new Uint32Array(bytes(base64));

// A column of numbers (packing.h).
export const column = (packed, count) => {
  if (typeof packed === "number") return new Float64Array(count).fill(packed);
  return Float64Array.from(floats(packed.data), (difference) => packed.base + difference);
};

const unpackRigging = (rigging) => {
  rigging.times = doubles(rigging.times);
  const count = rigging.times.length;
  for (const line of rigging.lines) {
    line.tension = column(line.tension, count);
    line.broken = column(line.broken, count);
    if (line.path) line.path = floats(line.path);
    if (line.shape) line.shape = floats(line.shape);
  }
  for (const part of rigging.parts)
    for (const turn of part.turns) turn.angle = column(turn.angle, count);
};

// The first six signals of a body are its motions, and those of all bodies come first.
const MOTIONS = 6;
const unpackAnalysis = (run) => {
  const {analysis} = run;
  analysis.motions = MOTIONS * run.bodies.length;
  for (const {spectrum, response} of analysis.signals) {
    if (spectrum) spectrum.density = floats(spectrum.density);
    if (response)
      for (const key of ["amplitude", "phase_deg", "coherence", "wave"]) response[key] = floats(response[key]);
  }
};

// What the replay draws (replay_data).
export const unpackReplay = (run) => {
  run.poses.times = doubles(run.poses.times);
  run.poses.tracks = run.poses.bodies.map(floats);
  if (run.water?.components) run.water.components = doubles(run.water.components);
  if (run.water?.heights) run.water.heights = floats(run.water.heights);
  if (run.rigging) unpackRigging(run.rigging);
  return run;
};

export const readRun = () => {
  const run = unpackReplay(JSON.parse(document.getElementById("data").textContent));
  run.series.times = doubles(run.series.times);
  for (const things of Object.values(run.series.rig))
    for (const thing of things)
      for (const [name, packed] of Object.entries(thing.columns))
        thing.columns[name] = column(packed, run.series.times.length);
  if (run.analysis) unpackAnalysis(run);
  return run;
};

// The plotted columns of one body by their names.
export const seriesOf = (run, body) => {
  const columns = {};
  run.series.columns.forEach((name, i) => {
    columns[name] = column(run.series.bodies[body][i], run.series.times.length);
  });
  return columns;
};

// Index of the last of ascending times that is not after t; 0 if all are.
export const rowAt = (times, t) => {
  let low = 0, high = times.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (times[middle] <= t) low = middle; else high = middle - 1;
  }
  return low;
};

const SAME_TIME = 1e-9;  // of a time, or s below 1 s, as the program takes it

// All times of some logs, ascending.
export const union = (logs) => {
  const all = Float64Array.from(logs.flatMap((log) => [...log.times])).sort();
  return all.filter((t, i) => i === 0 || t - all[i - 1] > SAME_TIME * Math.max(1, t));
};

// A column at other times: on the line between its rows, null before and after them.
export const onTimes = (own, values, times) => Array.from(times, (t) => {
  const near = SAME_TIME * Math.max(1, t);
  const row = rowAt(own, t + near);
  if (Math.abs(own[row] - t) <= near) return values[row];
  if (t < own[0] || row === own.length - 1) return null;
  const s = (t - own[row]) / (own[row + 1] - own[row]);
  return (1 - s) * values[row] + s * values[row + 1];
});
