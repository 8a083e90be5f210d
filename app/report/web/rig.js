// Plots of lines, joints, machines and controls, and of the course of a body that a machine drives.

import {number} from "./format.js";
import {isLong} from "./track.js";

const COLORS = 17;  // --c1 … --c17 of style.css
const POSE_NUMBERS = 7;  // x, y, z, qx, qy, qz, qw
const colorOf = (i) => `--c${1 + i % COLORS}`;
const varies = (values) => values.some((value) => value !== values[0]);
const isUsed = (values) => values.some((value) => value !== 0);

// A line of a plot for each of the things that has the column.
const linesOf = (things, name, more = {}) =>
  things.flatMap((thing) => thing.columns[name]
    ? [{label: thing.label, color: thing.color, values: thing.columns[name], ...more}] : []);

// The things of a list that are on a body, with a label and a color.
const onBody = (things, body) => things.filter(({bodies}) => bodies.includes(body))
  .map((thing, i) => ({...thing, label: thing.name, color: colorOf(i)}));

const drawn = (charts) => charts.filter((chart) => chart.lines.length > 0);

const lineCharts = (lines) => {
  const moments = lines.filter((line) => line.broken_at !== null)
    .map((line) => ({time: line.broken_at, text: `${line.name} breaks`}));
  const note = moments.map(({time, text}) => `${text} at ${number(time)} s`).join(", ");
  const unstretched = lines.filter((line) => varies(line.columns.length) || lines.length === 1)
    .map((line) => ({...line, label: `${line.label}, unstretched`}));
  return drawn([
    {title: "Tension", unit: "N", prefixed: true, moments, note, lines: linesOf(lines, "tension")},
    {title: "Distance of the ends", unit: "m", moments,
     lines: [...linesOf(lines, "distance"), ...linesOf(unstretched, "length", {dash: [4, 3]})]},
    {title: "Length on the bottom", unit: "m", lines: linesOf(lines, "resting")}]);
};

const jointCharts = (joints) => {
  const hinges = joints.filter(({type}) => type === "hinge");
  const sliders = joints.filter(({type}) => type === "slider");
  const used = (things, column) => linesOf(things, column).filter((line) => isUsed(line.values));
  return drawn([
    {title: "Angle of hinges", unit: "°", lines: linesOf(hinges, "coordinate")},
    {title: "Rate of hinges", unit: "°/s", lines: linesOf(hinges, "speed")},
    {title: "Effort along hinges", unit: "N m", prefixed: true, lines: used(hinges, "effort")},
    {title: "Displacement of sliders", unit: "m", lines: linesOf(sliders, "coordinate")},
    {title: "Speed of sliders", unit: "m/s", lines: linesOf(sliders, "speed")},
    {title: "Effort along sliders", unit: "N", prefixed: true, lines: used(sliders, "effort")},
    {title: "Power absorbed along joints", unit: "W", prefixed: true,
     lines: used([...hinges, ...sliders], "power")},
    {title: "Size of the force", unit: "N", prefixed: true, fromZero: true, lines: linesOf(joints, "force")}]);
};

const machineCharts = (propellers, foils) => {
  const turned = propellers.filter(({columns}) => isUsed(columns.angle));
  const aired = propellers.filter(({columns}) => columns.wetted.some((share) => share < 1));
  return drawn([
    {title: "Speed of propellers", unit: "1/s", lines: linesOf(propellers, "setting")},
    {title: "Thrust", unit: "N", prefixed: true, lines: linesOf(propellers, "thrust")},
    {title: "Torque of the shaft", unit: "N m", prefixed: true, lines: linesOf(propellers, "torque")},
    {title: "Advance ratio", unit: "1", lines: linesOf(propellers, "advance")},
    {title: "Share of the disc in the water", unit: "1", lines: linesOf(aired, "wetted")},
    {title: "Azimuth of propellers", unit: "°", lines: linesOf(turned, "angle")},
    {title: "Angle of rudders and sails", unit: "°", lines: linesOf(foils, "angle")},
    {title: "Angle of attack", unit: "°", lines: linesOf(foils, "attack")},
    {title: "Speed of the flow", unit: "m/s", fromZero: true, lines: linesOf(foils, "flow")},
    {title: "Force of rudders and sails", unit: "N", prefixed: true, fromZero: true,
     lines: linesOf(foils, "force")}]);
};

// What the names of set points end in: a title, and the unit.
const SETTINGS = [
  [/_rps$/, "Speed of propellers", "1/s"], [/_deg_s$/, "Rate of turn", "°/s"],
  [/_deg$/, "Angle", "°"], [/length$/, "Length", "m"], [/rate$/, "Rate", "m/s"]];

const controlCharts = (controls) => {
  const charts = new Map();
  controls.forEach(({name, columns}, i) => {
    const [, title, unit] = SETTINGS.find(([ending]) => ending.test(name)) ?? [null, name, "set point"];
    if (!charts.has(title)) charts.set(title, {title, unit, lines: []});
    charts.get(title).lines.push({label: name, color: colorOf(i), values: columns.value});
  });
  return [...charts.values()];
};

// The groups of a body: what is fastened to it or drives it, and all controls.
export const rigOf = (run, body) => {
  const {lines, joints, propellers, foils, controls} = run.series.rig;
  const screws = onBody(propellers, body);
  const fins = onBody(foils, body).map((foil, i) => ({...foil, color: colorOf(screws.length + i)}));
  return [{title: "Lines", charts: lineCharts(onBody(lines, body))},
          {title: "Joints", charts: jointCharts(onBody(joints, body))},
          {title: "Machines", charts: machineCharts(screws, fins)},
          {title: "Controls", charts: controlCharts(controls)}].filter(({charts}) => charts.length > 0);
};

// Place and heading of a body, at the times of the replay: those of the plots may be thinned
// column by column, and then belong to no common time.
const trackOf = (run, body) => {
  const numbers = run.poses.tracks[body], {times} = run.poses;
  const track = {times, x: [], y: [], heading: []};
  times.forEach((_, i) => {
    const [x, y, , qx, qy, qz, qw] = numbers.subarray(POSE_NUMBERS * i, POSE_NUMBERS * (i + 1));
    const yaw = Math.atan2(2 * (qw * qz + qx * qy), 1 - 2 * (qy * qy + qz * qz)) * 180 / Math.PI;
    const last = track.heading.at(-1) ?? yaw;
    track.x.push(run.origin[0] + x);
    track.y.push(run.origin[1] + y);
    track.heading.push(yaw - 360 * Math.round((yaw - last) / 360));
  });
  return track;
};

// The way of a body that has machines, and its heading with what steers it.
export const courseOf = (run, body, columns) => {
  const {propellers, foils} = run.series.rig;
  const screws = onBody(propellers, body), fins = onBody(foils, body);
  if (screws.length + fins.length === 0) return [];
  const steering = [...fins, ...screws.filter((screw) => isUsed(screw.columns.angle))]
    .map((thing, i) => ({...thing, color: colorOf(1 + i)}));
  const track = trackOf(run, body), wide = isLong(track);
  const heading = {wide, title: steering.length > 0 ? "Heading, and what steers" : "Heading", unit: "°",
                   lines: [{label: "heading", color: "--c1", width: 2.5, values: columns.yaw},
                           ...linesOf(steering, "angle")]};
  return [{title: "Course", charts: [{title: "Track", wide, track}, heading]}];
};
