// What the summary tells: the head of the page, and the details at its end.
import {element, grouped, number, tile} from "./format.js";

const PARTS = [["added_mass", "added mass", "--c7"], ["hydro", "loads of the water", "--c1"],
               ["collision", "collision", "--c4"], ["engine", "engine", "--c3"],
               ["log", "log", "--c5"], ["render", "pictures", "--c2"]];
const MOST_BODIES = 200;  // rows of the table

const seconds = (s) => s >= 1 ? `${number(s, 3)} s` : `${number(1000 * s, 3)} ms`;

// Wall time by stage, as one bar; what no stage has is the rest.
const wallTime = (wall) => {
  const parts = PARTS.map(([key, label, color]) => ({label, color, time: wall[key] ?? 0}));
  const rest = wall.total - parts.reduce((s, part) => s + part.time, 0);
  if (rest > 0) parts.push({label: "other", color: "--dim", time: rest});
  const shown = parts.filter((part) => part.time > 0);
  const bar = element("div", {className: "wall"}), key = element("div", {className: "key"});
  for (const {label, color, time} of shown) {
    const share = 100 * time / wall.total;
    const text = `${label} ${seconds(time)} (${share.toFixed(share < 10 ? 1 : 0)} %)`;
    const piece = element("i", {title: text});
    piece.style.cssText = `flex-grow:${share};background:var(${color})`;
    bar.append(piece);
    const dot = element("i", {className: "dot"});
    dot.style.background = `var(${color})`;
    if (share >= 0.5) key.append(element("span", {}, dot, text));
  }
  return element("div", {className: "tile wide"},
    element("span", {textContent: `Wall time ${seconds(wall.total)}`}), bar, key);
};

const waterText = (water) => {
  if (!water) return ["none", "dry scene"];
  const density = `${number(water.density)} kg/m³`;
  if (water.kind === "flat") return ["flat", density];
  if (water.kind === "heightfield") return [`${water.of_columns} × ${water.of_rows}`, `height field, ${density}`];
  const count = water.components.length / 5;
  return [count === 1 ? "1 wave" : `${count} waves`, density];
};

export const showHead = (run, host) => {
  const {summary: s} = run;
  const triangles = run.bodies.reduce((sum, body) => sum + run.shapes[body.shape].of_faces, 0);
  const name = run.title || run.scene.file.split("/").pop().replace(/\.ya?ml$/, "");
  document.title = `${name} – Plimsoll`;
  const state = s?.ended ?? "no summary";
  const tiles = element("div", {className: "tiles"});
  if (s) {
    tiles.append(
      tile("Simulated", `${number(s.simulated_seconds)} s`, `${grouped(s.steps)} steps`),
      tile("Real-time factor", `${number(s.real_time_factor, 3)} ×`,
           s.threads === 1 ? "1 thread" : `${s.threads} threads`));
  }
  tiles.append(
    run.rows === 1 ? tile("Logged", "1 row", "the initial state")
      : tile("Logged", `${grouped(run.rows)} rows`, "of each body"),
    tile("Bodies", grouped(run.bodies.length), `${grouped(triangles)} triangles`),
    tile("Water", ...waterText(run.water)));
  if (s) tiles.append(wallTime(s.wall_seconds));
  host.append(
    element("div", {className: "title"},
      element("h1", {textContent: name}),
      element("span", {className: `state ${state}`, textContent: state}),
      element("span", {className: "origin", title: run.scene.file,
        textContent: `${s?.scene ?? run.scene.file} · Plimsoll ${s?.version ?? run.program}`})),
    tiles);
  for (const text of [s?.error && `Error: ${s.error}`, ...(s?.warnings ?? []).map((w) => `Warning: ${w}`)])
    if (text) host.append(element("p", {className: "notice", textContent: text}));
};

// What was left out or made coarser so that the page stays small.
const limits = (run) => {
  const notes = [];
  if (run.series.thinned)
    notes.push(`Plots have ${grouped(run.series.times.length)} of ${grouped(run.rows)} logged rows: of each ` +
               "interval the least and the largest value. Sums of columns are left out.");
  if (run.poses.times.length < run.rows)
    notes.push(`The replay has ${grouped(run.poses.times.length)} of ${grouped(run.rows)} logged poses.`);
  if (run.frames && run.frames.images.length < run.frames.of)
    notes.push(`${run.frames.images.length} of ${run.frames.of} pictures are shown.`);
  const coarse = run.shapes.filter((shape) => shape.faces < shape.of_faces);
  if (coarse.length > 0)
    notes.push((coarse.length === 1 ? "One mesh is" : `${coarse.length} meshes are`) +
               " coarser in the replay than in the run.");
  const {water} = run;
  if (water?.kind === "heightfield" && water.rows * water.columns < water.of_rows * water.of_columns)
    notes.push(`The replay has ${water.columns} × ${water.rows} of ${water.of_columns} × ${water.of_rows} ` +
               "heights of the water.");
  return notes;
};

const skips = ({skipped, bodies}) => {
  const notes = [];
  if (skipped.collision) notes.push("Collision: nothing in the scene can collide.");
  if (skipped.water) notes.push("Water: no water, or no body that it acts on.");
  if (skipped.pictures) notes.push(`Pictures: ${skipped.pictures}.`);
  const sum = (key) => Object.values(bodies).reduce((s, body) => s + (body[key] ?? 0), 0);
  const dry = sum("steps_above_water"), resting = sum("steps_at_rest");
  if (dry) notes.push(`Loads above the highest water: ${grouped(dry)} evaluations.`);
  if (resting) notes.push(`Loads of bodies at rest in still water: ${grouped(resting)} evaluations.`);
  return notes;
};

const list = (title, notes) => notes.length === 0 ? "" :
  element("div", {className: "card"}, element("h2", {textContent: title}),
          element("ul", {}, ...notes.map((note) => element("li", {textContent: note}))));

const bodyTable = (run, select) => {
  const head = ["body", "mass [kg]", "triangles", "steps free", "constrained", "substeps", "above water",
                "at rest", "loads left out"];
  const table = element("table", {}, element("tr", {}, ...head.map((t) => element("th", {textContent: t}))));
  run.bodies.slice(0, MOST_BODIES).forEach((body, i) => {
    const s = run.summary?.bodies?.[body.name];
    const count = (value) => value === undefined ? "–" : grouped(value);
    const cells = [body.name, number(body.mass), grouped(run.shapes[body.shape].of_faces),
                   count(s?.motion?.free_steps), count(s?.motion?.constrained_steps), count(s?.motion?.pieces),
                   count(s?.steps_above_water), count(s?.steps_at_rest),
                   s?.loads_not_computed?.map((l) => l.replace("_", " ")).join(", ") || "–"];
    const row = element("tr", {onclick: () => select(i)}, ...cells.map((t) => element("td", {textContent: t})));
    table.append(row);
  });
  const more = run.bodies.length > MOST_BODIES
    ? element("p", {className: "note",
                    textContent: `The first ${MOST_BODIES} of ${grouped(run.bodies.length)} bodies.`}) : "";
  return element("div", {className: "card scroll"}, element("h2", {textContent: "Bodies"}), table, more);
};

// The scene's text: comments dimmed, keys in the accent's colour.
const sceneText = ({text, overrides}) => {
  const code = element("pre");
  for (const line of text.replace(/\n$/, "").split("\n")) {
    const [, before, comment] = /^((?:[^#"']|"[^"]*"|'[^']*'|(?<=\S)#)*)(#.*)?$/.exec(line) ?? [null, line, ""];
    const row = element("div");
    before.split(/([A-Za-z_]\w*(?=:(?:\s|$)))/).forEach((part, i) =>
      row.append(i % 2 ? element("b", {textContent: part}) : part));
    if (comment) row.append(element("i", {textContent: comment}));
    code.append(row);
  }
  const over = overrides.length === 0 ? "" : element("p", {className: "note"},
    "From the command line: ", element("code", {textContent: overrides.map((o) => `--set ${o}`).join("  ")}));
  return element("div", {className: "card"}, element("h2", {textContent: "Scene"}), over, code);
};

export const showDetails = (run, host, select) => {
  host.append(
    element("div", {className: "column"}, sceneText(run.scene)),
    element("div", {className: "column"}, bodyTable(run, select),
            run.summary ? list("Not computed, since the scene did not need it", skips(run.summary)) : "",
            list("Shortened in this page", limits(run))));
};
