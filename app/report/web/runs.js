// The page of several runs: the motions and loads of a selected body in each, laid over each other.
import "./style.css";
import "./runs.css";
import {LOADS} from "./charts.js";
import {addChooser, USAGE} from "./chooser.js";
import {Clock} from "./clock.js";
import {column, doubles, onTimes, union} from "./data.js";
import {LEAST, largestOf} from "./extent.js";
import {at, element, grouped} from "./format.js";
import {Plots} from "./plots.js";
import {QUANTITIES} from "./quantities.js";

const COLORS = 17;       // of style.css
const ROUNDING = 1e-6;   // of the largest load of a body, for what others leave of it
const COMPONENTS = [["fx", "force x", "N"], ["fy", "force y", "N"], ["fz", "force z", "N"],
                    ["tx", "torque x", "N m"], ["ty", "torque y", "N m"], ["tz", "torque z", "N m"]];
const WETNESS = [["wetted_area", "Wetted area", "m²"], ["displaced_volume", "Displaced volume", "m³"]];

// Earlier runs have wider lines, so that they are seen under later ones that do the same.
const WIDTH = 1.5, WIDER = 3;  // px
const widthOf = (run, count) => WIDTH + Math.min(count - 1 - run, WIDER);

const capital = (text) => text[0].toUpperCase() + text.slice(1);

const colorOf = (run) => `--c${1 + run % COLORS}`;
const dashOf = (run) => run < COLORS ? undefined : [4 + 2 * Math.floor(run / COLORS), 3];

const readRuns = () => {
  const page = JSON.parse(at("data").textContent);
  for (const {runs} of page.bodies)
    for (const run of runs.filter(Boolean))
      for (const log of [run.motion, run.loads]) if (log) log.times = doubles(log.times);
  return page;
};

// A line for each run that has a column.
// @param log   `motion` or `loads`
const linesOf = (page, body, log, index, times) => body.runs.flatMap((run, i) => {
  const of = run?.[log];
  if (!of) return [];
  const values = onTimes(of.times, column(of.columns[index], of.times.length), times);
  return [{label: page.runs[i], color: colorOf(i), dash: dashOf(i), width: widthOf(i, body.runs.length), values}];
});

const varies = ({lines}) => {
  const first = lines[0]?.values.find((value) => value !== null);
  return lines.some(({values}) => values.some((value) => value !== null && value !== first));
};

const motionGroups = (page, body, times) => QUANTITIES.map(({title, unit, names, labels = names}) => ({
  title, charts: names.map((name, i) => ({title: `${title}, ${labels[i]}`, unit, least: LEAST[unit],
    lines: linesOf(page, body, "motion", page.motion.indexOf(name), times)}))}));

// A group a load, with its components that vary in a run or between runs.
const loadGroups = (page, body, times) => {
  const chart = (name, title, unit, more) => ({title, unit, ...more,
    lines: linesOf(page, body, "loads", page.loads.indexOf(name), times)});
  const groups = LOADS.map(([key, label]) => ({title: capital(label),
    charts: COMPONENTS.map(([suffix, title, unit]) => chart(`${key}_${suffix}`, `${capital(label)}, ${title}`, unit, {prefixed: true}))}));
  for (const unit of ["N", "N m"]) {
    const alike = groups.flatMap(({charts}) => charts).filter((one) => one.unit === unit);
    const least = ROUNDING * Math.max(...alike.map(largestOf));
    for (const one of alike) one.least = least;
  }
  groups.push({title: "Wet part", charts: WETNESS.map(([name, title, unit]) => chart(name, title, unit))});
  return groups.map(({title, charts}) => ({title, charts: charts.filter(varies)}))
    .filter(({charts}) => charts.length > 0);
};

const plotsOf = (page) => (index) => {
  const body = page.bodies[index];
  const logs = body.runs.filter(Boolean).flatMap(({motion, loads}) => [motion, loads]).filter(Boolean);
  const times = union(logs);
  return {times, groups: [...motionGroups(page, body, times), ...loadGroups(page, body, times)]};
};

// @return the function that marks the runs which have a body
const showHead = (page) => {
  document.title = `${page.runs.join(", ")} – Plimsoll`;
  const entries = page.runs.map((name, i) => {
    const dot = element("i", {className: "dot"});
    dot.style.background = `var(${colorOf(i)})`;
    return element("li", {}, dot, name);
  });
  const note = element("p", {className: "note"});
  at("head").append(
    element("div", {className: "title"}, element("h1", {textContent: `${grouped(page.runs.length)} runs`}),
      element("span", {className: "origin", textContent: `Plimsoll ${page.program}`})),
    element("ul", {id: "runs"}, ...entries), note);
  return ({name, runs}) => {
    entries.forEach((entry, i) => entry.classList.toggle("lacks", !runs[i]));
    const without = page.runs.filter((_, i) => !runs[i]);
    const thinned = runs.some((run) => run && run.motion.times.length < run.motion.rows);
    note.textContent = [
      without.length > 0 && `Without ${name}: ${without.join(", ")}.`,
      thinned && "Plots have of each interval of rows the least and the largest value."]
      .filter(Boolean).join(" ");
  };
};

const page = readRuns();
const mark = showHead(page);
const logs = page.bodies.flatMap(({runs}) => runs.filter(Boolean).map(({motion}) => motion));
const clock = new Clock(Math.min(...logs.map(({times}) => times[0])), Math.max(...logs.map(({times}) => times.at(-1))));
const plots = new Plots(plotsOf(page), clock, at("charts"));
addChooser(at("chooser"), page.bodies.map(({name}) => name), plots, USAGE, (body) => {
  mark(page.bodies[body]);
  plots.show(body);
})(0);
