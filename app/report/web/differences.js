// The comparison as the program has written it into the page (comparison_data.h), and which plots
// a body has.
import {column, doubles, onTimes, union, unpackReplay} from "./data.js";
import {number} from "./format.js";
import {QUANTITIES} from "./quantities.js";

// How many times its tolerance a difference is; −1 if it is not judged.
export const severity = ({largest, tolerance, rms, rms_tolerance: rmsTolerance, judged}) => {
  if (!judged) return -1;
  const ratio = (found, limit) => found === 0 || limit === null ? 0 : found / limit;
  return Math.max(ratio(largest ?? Infinity, tolerance), ratio(rms ?? Infinity, rmsTolerance));
};

const descending = (a, b) => (b > a) - (b < a);  // of infinite numbers, too

// Indices of a body's quantities, the worst one first.
export const worstFirst = (differences) => QUANTITIES.map((_, i) => i).sort((i, j) =>
  descending(severity(differences[i]), severity(differences[j])));

export const readComparison = () => {
  const comparison = JSON.parse(document.getElementById("data").textContent);
  for (const body of comparison.bodies) {
    body.severity = Math.max(body.same ? -1 : 1, ...(body.differences ?? []).map(severity));
    for (const key of ["a", "b", "over"]) if (body[key]) body[key].times = doubles(body[key].times);
  }
  for (const run of [comparison.replay.a, comparison.replay.b]) if (run) unpackReplay(run);
  comparison.bodies.sort((p, q) => descending(p.severity, q.severity));
  return comparison;
};

const verdictOf = ({verdict, first_beyond: first}) =>
  first === null ? `: ${verdict}` : ` exceeds its tolerance from ${number(first, 6)} s on`;

const differenceChart = ({title}, d, values, log) => {
  const shown = (v) => log && !(v > 0) ? null : v;
  const lines = [{label: "difference", color: "--c7", values: values.map(shown)}];
  if (d.tolerance !== null)
    lines.push({label: "tolerance", color: "--bad", dash: [6, 4], values: values.map(() => shown(d.tolerance))});
  return {title: `Difference of ${title.toLowerCase()}`, unit: d.unit === "deg" ? "°" : d.unit, lines, log,
          fromZero: true};
};

// @param log   Whether differences have a logarithmic scale.
// @return what Plots shows of a body, the worst quantity first
export const plotsOf = (comparison, body, log) => {
  const times = union([body.a, body.b, body.over].filter(Boolean));
  const columnOf = (of, i) => onTimes(of.times, column(of.columns[i], of.times.length), times);
  const motion = (quantity, i, moments) => {
    const {title, unit, names, labels = names} = quantity;
    const at = comparison.columns.indexOf(names[i]);
    const lines = [["A", body.a, "--c1", 3.5], ["B", body.b, "--c2", 1.5]].filter(([, of]) => of)
      .map(([label, of, color, width]) => ({label, color, width, values: columnOf(of, at)}));
    return {title: `${title}, ${labels[i]}`, unit, lines, moments};
  };
  const order = body.differences ? worstFirst(body.differences) : QUANTITIES.map((_, i) => i);
  const groups = order.map((k) => {
    const d = body.differences?.[k];
    const beyond = d !== undefined && d.first_beyond !== null;
    const moments = beyond
      ? [{time: d.first_beyond, text: `${QUANTITIES[k].title}: beyond its tolerance from here on`}] : [];
    const charts = QUANTITIES[k].names.map((_, i) => motion(QUANTITIES[k], i, moments));
    if (d && body.over)
      charts.unshift({...differenceChart(QUANTITIES[k], d, columnOf(body.over, k), log && d.largest > 0), moments});
    return {title: QUANTITIES[k].title + (d ? verdictOf(d) : ""), bad: d !== undefined && !d.within, charts};
  });
  return {times, groups};
};
