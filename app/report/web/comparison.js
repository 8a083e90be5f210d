// The page of a comparison: the differences of all bodies, and the plots of a selected one.
import "./style.css";
import "./comparison.css";
import {addChooser, USAGE} from "./chooser.js";
import {Clock} from "./clock.js";
import {plotsOf, readComparison, severity, worstFirst} from "./differences.js";
import {at, element, grouped, number, tile} from "./format.js";
import {Plots} from "./plots.js";
import {QUANTITIES} from "./quantities.js";
import {color, makeReplay, makeToggles, makeTransport, makeViews} from "./stage.js";

const MOST_BODIES = 500;  // in the table
const LOG_FROM = 30;      // tolerances, or as many parts of one, beyond which a line is flat without it
const DIGITS = 4;

const withUnit = (value, unit) => `${number(value, DIGITS)}${unit === "°" ? "" : " "}${unit}`;
const seconds = (t) => `${number(t, 6)} s`;

const log = (label, name) =>
  element("span", {className: `log ${label}`}, element("i", {className: "dot"}), element("b", {textContent: label}),
          " ", element("span", {textContent: name}));

// The body with the most of something of a quantity.
const most = (bodies, of) => bodies.reduce((best, body) => best && of(best) >= of(body) ? best : body, null);

const showHead = ({a, b, same, verdict, bodies, program}) => {
  document.title = `${a} and ${b} – Plimsoll`;
  const compared = bodies.filter((body) => body.differences);
  const different = bodies.filter((body) => !body.same);
  const tiles = element("div", {className: "tiles"}, tile("Bodies", grouped(bodies.length),
    different.length === 0 ? "all the same" : `${grouped(different.length)} different`));
  const firsts = compared.flatMap((body) => body.differences
    .map((d, i) => ({time: d.first_beyond, text: `${body.name}, ${QUANTITIES[i].title.toLowerCase()}`}))
    .filter(({time}) => time !== null));
  const first = firsts.reduce((p, q) => p && p.time <= q.time ? p : q, null);
  if (first) tiles.append(tile("First beyond tolerance", seconds(first.time), first.text));
  if (compared.length > 0)
    QUANTITIES.forEach(({title, unit}, i) => {
      const body = most(compared, ({differences}) => differences[i].largest);
      const {largest, at: when} = body.differences[i];
      tiles.append(tile(`Largest difference of ${title.toLowerCase()}`, withUnit(largest, unit),
                        largest === 0 ? "none" : `${body.name}, at ${seconds(when)}`));
    });
  at("head").append(
    element("div", {className: "title"}, element("h1", {textContent: "Comparison"}),
      element("span", {id: "verdict", className: same ? "state completed" : "state",
                       textContent: verdict}),
      log("A", a), log("B", b), element("span", {className: "origin", textContent: `Plimsoll ${program}`})),
    tiles);
};

const ratioText = (d) => {
  const ratio = severity(d);
  if (ratio < 0) return "–";
  return ratio === Infinity ? "∞" : number(ratio, 3);
};

const cellsOf = (name, quantity, unit, d) =>
  [name, quantity, d.verdict, ratioText(d), d.largest === null ? "∞" : withUnit(d.largest, unit), number(d.at, 6),
   d.judged ? d.limits : "–"].map((textContent) => element("td", {textContent}));

const rowsOf = (body, select) => {
  const rows = [];
  const notes = [body.note, body.interpolated > 0 &&
                            `interpolated at ${grouped(body.interpolated)} of ${grouped(body.times)} times`];
  for (const note of notes.filter(Boolean))
    rows.push(element("tr", {className: body.same || note !== body.note ? "skip" : "bad"},
      element("td", {textContent: body.name, title: body.name}), element("td", {colSpan: 6, textContent: note})));
  (body.differences ?? []).forEach((d, i) => rows.push(
    element("tr", {className: !d.judged ? "skip" : d.within ? "good" : "bad", onclick: () => select(i)},
      ...cellsOf(body.name, QUANTITIES[i].title, QUANTITIES[i].unit, d))));
  rows[0]?.classList.add("first");
  return rows;
};

// The rows of a table of the runs: its verdict, and what in it is beyond its tolerance.
const rowsOfTable = ({name, same, judged, note, names, beyond}) => {
  const said = note ? `${note}${judged ? "" : ", not judged"}`
    : `${grouped(names)} compared, ${same ? "all within tolerance" : `${grouped(beyond.length)} different`}`;
  const rows = [element("tr", {className: `first ${same ? "skip" : "bad"}`},
    element("td", {textContent: name}), element("td", {colSpan: 6, textContent: said}))];
  for (const {name: thing, note: missing, differences} of beyond) {
    if (missing) rows.push(element("tr", {className: "bad"}, element("td", {textContent: name}),
                                   element("td", {colSpan: 6, textContent: `${thing}: ${missing}`})));
    for (const d of differences)
      rows.push(element("tr", {className: "bad"},
        ...cellsOf(name, `${thing} ${d.quantity.slice(name.length + 1)}`, d.unit, d)));
  }
  return rows;
};

// What made the runs differ: versions, keys of the scenes, meshes.
const showChanges = (differs) => {
  const kinds = [["programs", "program"], ["keys", "scene key"], ["meshes", "mesh of"]];
  const parts = kinds.flatMap(([key, title]) => {
    const all = Object.entries(differs[key]);
    return all.length === 0 ? [] : [element("tbody", {},
      element("tr", {}, ...[title, "A", "B"].map((textContent) => element("th", {textContent}))),
      ...all.map(([what, [a, b]]) => element("tr", {}, ...[what, a ?? "–", b ?? "–"].map((textContent) =>
        element("td", {textContent})))))];
  });
  const notes = differs.notes.map((textContent) => element("p", {className: "note", textContent}));
  if (parts.length + notes.length === 0)
    notes.push(element("p", {className: "note", textContent: "Program, scene and meshes are the same."}));
  at("changes").append(...(parts.length > 0 ? [element("table", {}, ...parts)] : []), ...notes);
  at("changes").hidden = false;
};

// @param select   Called with a body and a quantity.
// @return the function that marks the rows of a body
const showTable = ({bodies, tables}, select) => {
  const head = ["body", "quantity", "verdict", "× tolerance", "largest", "at [s]", "tolerance"];
  const table = element("table", {}, element("thead", {}, element("tr", {}, ...head.map((textContent) =>
    element("th", {textContent})))));
  const parts = bodies.slice(0, MOST_BODIES).map((body, i) =>
    element("tbody", {}, ...rowsOf(body, (quantity) => select(i, quantity))));
  table.append(...parts, ...tables.map((one) => element("tbody", {className: "of-run"}, ...rowsOfTable(one))));
  at("table").append(element("div", {className: "scroll"}, table));
  const notes = [];
  if (bodies.length > MOST_BODIES)
    notes.push(`The ${MOST_BODIES} worst of ${grouped(bodies.length)} bodies.`);
  const longest = most(bodies.flatMap(({a, b}) => [a, b]).filter(Boolean), ({rows}) => rows);
  if (longest && longest.times.length < longest.rows)
    notes.push(`Plots have ${grouped(longest.times.length)} of ${grouped(longest.rows)} rows: of each interval ` +
               "the least and the largest value.");
  if (notes.length > 0) at("table").append(element("p", {className: "note", textContent: notes.join(" ")}));
  return (body) => parts.forEach((part, i) => part.classList.toggle("on", i === body));
};

// Both runs in three dimensions; null where there is nothing to draw, which the page then says.
const showReplay = ({replay}, clock) => {
  if (replay.note) {
    at("stage").replaceChildren(element("p", {className: "note", id: "no-replay",
                                              textContent: `There is no replay: ${replay.note}.`}));
    return null;
  }
  if (replay.a.bodies.length === 0) {
    at("stage").hidden = true;
    return null;
  }
  makeTransport(clock);
  const made = makeReplay(replay.a, clock, {run: replay.b, color: color("--c2")});
  makeViews(replay.a, made);
  if (made) makeToggles(made);
  if (made) at("key").append(log("A", "solid"), log("B", "translucent"));
  return made;
};

const isFar = (d) => {
  const ratio = severity(d);
  return ratio > LOG_FROM || (ratio > 0 && ratio < 1 / LOG_FROM);
};

const comparison = readComparison();
const {bodies} = comparison;
showHead(comparison);
if (comparison.differs) showChanges(comparison.differs);
if (bodies.length > 0) {
  const logs = bodies.flatMap(({a, b}) => [a, b]).filter(Boolean);
  const clock = new Clock(Math.min(...logs.map((l) => l.times[0])), Math.max(...logs.map((l) => l.times.at(-1))));
  const replay = showReplay(comparison, clock);
  const indexIn = (list, name) => list.findIndex((body) => body.name === name);
  const worst = bodies[0].differences?.[worstFirst(bodies[0].differences)[0]];
  const logarithmic = element("input", {type: "checkbox", id: "log", checked: worst !== undefined && isFar(worst)});
  const plots = new Plots((body) => plotsOf(comparison, bodies[body], logarithmic.checked), clock, at("charts"));
  const mark = showTable(comparison, (body, quantity) => {
    select(body);
    const order = bodies[body].differences ? worstFirst(bodies[body].differences) : [];
    at("charts").children[order.indexOf(quantity)].scrollIntoView({behavior: "smooth"});
  });
  let shown = 0;
  const select = addChooser(at("chooser"), bodies.map((body) => body.name), plots, USAGE, (body) => {
    shown = body;
    const {differences} = bodies[body];
    const d = differences?.[worstFirst(differences)[0]];
    plots.show(body);
    mark(body);
    const drawn = replay ? indexIn(replay.run.bodies, bodies[body].name) : -1;
    if (drawn >= 0) {
      replay.select(drawn);
      at("label").textContent = bodies[body].name;
    }
    clock.seek(d?.first_beyond ?? d?.at ?? clock.start);
  });
  if (replay) replay.onSelect = (drawn) => select(indexIn(bodies, replay.run.bodies[drawn].name));
  logarithmic.onchange = () => plots.show(shown);
  at("body").after(element("label", {className: "dim", title: "Of the differences"}, logarithmic, "logarithmic"));
  select(0);
} else {
  at("stage").hidden = true;
}
