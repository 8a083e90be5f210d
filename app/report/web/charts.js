// Which plots a run has, and of which lines.
import {LEAST, largestOf} from "./extent.js";
import {QUANTITIES} from "./quantities.js";
import {courseOf, rigOf} from "./rig.js";

export const LOADS = [
  ["weight", "weight", "--c2"], ["buoyancy", "buoyancy", "--c1"],
  ["pressure_drag", "pressure drag", "--c3"], ["viscous_drag", "viscous drag", "--c4"],
  ["lift", "lift", "--c5"], ["wave_inertia", "wave inertia", "--c9"], ["wind", "wind", "--c10"],
  ["diffraction", "diffraction", "--c11"], ["radiation", "radiation", "--c12"],
  ["water", "simulated water", "--c12"],
  ["interior", "water inside", "--c13"], ["lines", "lines", "--c14"], ["machines", "machines", "--c15"],
  ["resistance", "resistance", "--c16"], ["hull_lift", "lift of the hull", "--c17"],
  ["added_mass", "added mass", "--c7"],
  ["applied", "applied", "--c6"], ["constraint", "constraint", "--c8"]];
const AXES = ["--c1", "--c2", "--c3"];

const varies = (values) => values.some((v) => v !== 0);
const sum = (columns) => columns[0].map((_, i) => columns.reduce((s, c) => s + c[i], 0));

const ROUNDING = 1e-6;  // of the largest load or work, for what others leave of it

const motion = (columns) => QUANTITIES.map(({title, unit, names, labels = names}) => ({
  title, unit, least: LEAST[unit], lines: names.map((name, i) => ({label: labels[i], color: AXES[i], values: columns[name]}))}));

// One plot a component, with every load that acts in it.
const forces = (columns, thinned) => {
  const components = [["fx", "Force x", "N"], ["fy", "Force y", "N"], ["fz", "Force z", "N"],
                      ["tx", "Torque x", "N m"], ["ty", "Torque y", "N m"], ["tz", "Torque z", "N m"]];
  const wetness = [["wetted_area", "Wetted area", "m²"], ["displaced_volume", "Displaced volume", "m³"]];
  const charts = components.map(([suffix, title, unit]) => {
    const lines = LOADS.map(([key, label, color]) => ({label, color, values: columns[`${key}_${suffix}`]}))
      .filter((line) => varies(line.values));
    if (lines.length > 1 && !thinned)
      lines.push({label: "sum", color: "--ink", dash: [4, 3], values: sum(lines.map((l) => l.values))});
    return {title, unit, lines, prefixed: true};
  });
  for (const unit of ["N", "N m"]) {
    const alike = charts.filter((chart) => chart.unit === unit);
    const least = ROUNDING * Math.max(...alike.map(largestOf));
    for (const chart of alike) chart.least = least;
  }
  for (const [key, title, unit] of wetness)
    charts.push({title, unit, lines: [{label: title.toLowerCase(), color: "--c1", values: columns[key]}]});
  return charts.filter((chart) => chart.lines.some((line) => varies(line.values)));
};

// Of forces.csv: energies, the work of each load, and how well the one balances the other.
const energyBooks = (columns, thinned) => {
  const lines = (entries) => entries.map(([label, color, values]) => ({label, color, values}))
    .filter((line) => varies(line.values));
  const works = [...LOADS.map(([key, label, color]) => [label, color, columns[`work_${key}`]]),
                 ["brake", "--dim", columns.work_brake]];
  const charts = [
    {title: "Energy", unit: "J", prefixed: true, lines: lines([
      ["kinetic", "--c1", columns.kinetic_energy], ["potential", "--c2", columns.potential_energy],
      ["of the added mass", "--c7", columns.added_kinetic_energy]])},
    {title: "Work since the start", unit: "J", prefixed: true, lines: lines(works)}];
  if (!thinned) {
    const gain = columns.kinetic_energy.map((k) => k - columns.kinetic_energy[0]);
    const work = sum(works.map(([, , values]) => values));
    charts.push(
      {title: "Budget: gained and worked", unit: "J", prefixed: true, lines: [
        {label: "kinetic energy − initial", color: "--c1", values: gain, width: 3},
        {label: "sum of works", color: "--c2", values: work}]},
      {title: "Budget: what is not accounted for", unit: "J", prefixed: true,
       least: ROUNDING * largestOf({lines: works.map(([, , values]) => ({values}))}), lines: [
        {label: "gained − worked", color: "--c8", values: gain.map((k, i) => k - work[i])}]});
  }
  return charts.filter((chart) => chart.lines.length > 0);
};

// ½ ω·I ω with the inertia turned to where the body is.
const spinEnergy = (I, roll, pitch, yaw, w) => {
  const [xx, yy, zz, xy, xz, yz] = I;
  const [cr, sr, cp, sp, cy, sy] =
    [roll, pitch, yaw].flatMap((d) => [Math.cos(d * Math.PI / 180), Math.sin(d * Math.PI / 180)]);
  const a = [cy * cp * w[0] + sy * cp * w[1] - sp * w[2],
             (cy * sp * sr - sy * cr) * w[0] + (sy * sp * sr + cy * cr) * w[1] + cp * sr * w[2],
             (cy * sp * cr + sy * sr) * w[0] + (sy * sp * cr - cy * sr) * w[1] + cp * cr * w[2]];
  return 0.5 * (xx * a[0] ** 2 + yy * a[1] ** 2 + zz * a[2] ** 2) +
    xy * a[0] * a[1] + xz * a[0] * a[2] + yz * a[1] * a[2];
};

// Of a run without forces: what follows from the motion alone.
const energyOfMotion = (run, body, c) => {
  const {mass, inertia} = run.bodies[body];
  const level = run.water?.level ?? 0;
  const kinetic = c.x.map((_, i) =>
    0.5 * mass * (c.vx[i] ** 2 + c.vy[i] ** 2 + c.vz[i] ** 2) +
    spinEnergy(inertia, c.roll[i], c.pitch[i], c.yaw[i], [c.wx[i], c.wy[i], c.wz[i]]));
  const potential = c.z.map((z) => mass * run.gravity * (z - level));
  return [{title: "Energy of the body", unit: "J", prefixed: true, lines: [
    {label: "kinetic", color: "--c1", values: kinetic},
    {label: "potential", color: "--c2", values: potential},
    {label: "sum", color: "--ink", dash: [4, 3], values: sum([kinetic, potential])}]}];
};

// The water in each hollow of a body that had some.
const hollows = (columns, count) => {
  const lines = (quantity) => Array.from({length: count}, (_, i) => i)
    .filter((i) => varies(columns[`hollow_volume_${i}`]))
    .map((i) => ({label: `hollow ${i}`, color: `--c${1 + i}`, values: columns[`hollow_${quantity}_${i}`]}));
  return [{title: "Volume", unit: "m³", lines: lines("volume")}, {title: "Level", unit: "m", lines: lines("level")}]
    .filter((chart) => chart.lines.length > 0);
};

export const chartsOf = (run, body, columns) => {
  const {thinned, forces: logged} = run.series;
  const groups = [...courseOf(run, body, columns),
                  {title: "Motion of the centre of mass", charts: motion(columns)},
                  ...rigOf(run, body)];
  const inside = hollows(columns, run.series.hollows);
  if (inside.length > 0) groups.push({title: "Water inside", charts: inside});
  if (logged) {
    groups.push({title: "Loads, about the centre of mass", charts: forces(columns, thinned)});
    groups.push({title: "Energy and its budget", charts: energyBooks(columns, thinned)});
  } else if (!thinned) {
    groups.push({title: "Energy", charts: energyOfMotion(run, body, columns)});
  }
  return groups;
};
