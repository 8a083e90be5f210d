// The page of a run: everything on it shows the time of one clock and one selected body.
import "./style.css";
import {chartsOf} from "./charts.js";
import {addChooser, USAGE} from "./chooser.js";
import {Clock} from "./clock.js";
import {readRun, seriesOf} from "./data.js";
import {showDetails, showHead} from "./facts.js";
import {at, button, element, grouped, number, prefixOf} from "./format.js";
import {Plots} from "./plots.js";
import {pressureBar} from "./pressure.js";
import {Replay} from "./replay.js";
import {Strip} from "./strip.js";

const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 5, 10, 50];
const SLIDER_STEPS = 10000;
const KEY_STEPS = 200;  // a key moves the time by this part of the run

const color = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const look = () => ({water: color("--water"), waterLine: color("--water-line"), ground: color("--ground"),
                     groundLine: color("--ground-line"), path: color("--ink")});

const makeReplay = (run, clock) => {
  try {
    return new Replay(run, clock, at("replay"), at("label"), look());
  } catch (error) {
    at("replay").hidden = true;
    at("hint").hidden = at("label").hidden = true;
    at("view").append(element("p", {className: "notice", textContent:
      `The 3-D replay needs WebGL, which this browser does not give (${error.message}).`}));
    return null;
  }
};

const makeTransport = (clock) => {
  const play = button("▶", "Play or pause (space)", () => clock.play(!clock.playing));
  play.id = "play";
  const slider = element("input", {type: "range", id: "time", min: 0, max: SLIDER_STEPS, value: 0,
                                   ariaLabel: "Time"});
  slider.addEventListener("input", () => {
    clock.play(false);
    clock.seek(clock.start + (clock.end - clock.start) * slider.value / SLIDER_STEPS);
  });
  const shown = element("output", {id: "clock"});
  const speed = element("select", {title: "Speed of the replay"}, ...SPEEDS.map((s) =>
    element("option", {value: s, textContent: `${s} ×`, selected: s === clock.speed})));
  speed.addEventListener("change", () => { clock.speed = Number(speed.value); });
  at("transport").append(play, slider, shown, speed);
  const digits = Math.max(1, 2 - Math.floor(Math.log10(Math.max(clock.end - clock.start, 1e-9))) + 1);
  const update = () => {
    play.textContent = clock.playing ? "⏸" : "▶";
    slider.value = SLIDER_STEPS * (clock.time - clock.start) / Math.max(clock.end - clock.start, 1e-12);
    shown.textContent = `${clock.time.toFixed(Math.min(digits, 6))} / ${number(clock.end)} s`;
  };
  clock.onChange(update);
  update();
  document.addEventListener("keydown", (event) => {
    if (event.target.matches("input, select, textarea, button")) return;
    const step = (clock.end - clock.start) / KEY_STEPS;
    const moves = {ArrowLeft: -step, ArrowRight: step, Home: -Infinity, End: Infinity};
    if (event.key === " ") clock.play(!clock.playing);
    else if (event.key in moves) clock.seek(clock.time + moves[event.key]);
    else return;
    event.preventDefault();
  });
};

// Which of the two is seen, and from where.
const makeViews = (run, replay) => {
  const tabs = [];
  const show = (picture, tab) => {
    at("picture").hidden = !picture;
    at("replay").style.visibility = picture ? "hidden" : "";
    at("hint").hidden = at("label").hidden = picture;
    for (const scale of document.querySelectorAll("#tension, #pressure")) scale.hidden = picture;
    for (const other of tabs) other.classList.toggle("on", other === tab);
  };
  const addTab = (text, title, action) => {
    const tab = button(text, title, () => { action(); });
    tabs.push(tab);
    at("views").append(tab);
    return tab;
  };
  if (replay) {
    const views = [["3-D", "scene", run.camera ? "From the scene's camera" : "All bodies"],
                   ["Side", "side", "From −y"], ["Front", "front", "From +x"], ["Top", "top", "From above"]];
    for (const [text, view, title] of views) {
      const tab = addTab(text, title, () => { show(false, tab); replay.look(view); });
    }
  }
  if (run.frames) {
    const tab = addTab("Pictures", "The pictures of the run", () => show(true, tab));
    if (!replay) show(true, tab);
  }
  tabs[0]?.classList.add("on");
};

const makeToggles = (replay) => {
  const toggle = (text, on, change) => {
    const box = element("input", {type: "checkbox", checked: on, onchange: () => change(box.checked)});
    at("toggles").append(element("label", {}, box, text));
  };
  toggle("follow", replay.following, (on) => replay.follow(on));
  if (replay.water) toggle("water", true, (on) => { replay.water.group.visible = on; replay.wake(); });
  if (replay.rigging)
    toggle("rigging", true, (on) => { replay.rigging.group.visible = on; replay.wake(); });
  if (replay.pressure) {
    const bar = pressureBar(replay.run.pressure);
    at("view").append(bar);
    toggle("pressure", true, (on) => { replay.pressure.group.visible = on; bar.style.display = on ? "" : "none"; replay.wake(); });
  }
  toggle("path", true, (on) => { replay.path.visible = on; replay.wake(); });
  toggle("axes", true, (on) => { replay.axes.visible = on; replay.wake(); });
};

// The scale of the tensions of lines, beside the replay.
const makeTensionScale = ({tensions, lines}) => {
  if (lines.length === 0 || tensions.top === 0) return;
  const {pushes, push, colors, top} = tensions;
  const css = (color) => `rgb(${color.map((c) => Math.round(255 * c)).join()})`;
  const bar = element("i"), zero = pushes ? 50 : 0;
  const stops = colors.map((color, i) => `${css(color)} ${zero + (100 - zero) * i / (colors.length - 1)}%`);
  bar.style.background = `linear-gradient(to right, ${(pushes ? [`${css(push)} 0%`] : []).concat(stops).join()})`;
  const [factor, letter] = prefixOf(top);
  const end = number(top / factor);
  const text = `tension ${pushes ? `−${end}` : 0} … ${end} ${letter}N`;
  at("view").append(element("div", {id: "tension"}, bar, text));
};

// The body whose plots are shown. @return the function that selects one.
const makeChooser = (run, plots, replay) => {
  const swatch = element("i", {className: "swatch"});
  at("chooser").append(swatch);
  const usage = run.series.thinned
    ? `${grouped(run.series.times.length)} of ${grouped(run.rows)} rows: least and largest of each interval`
    : USAGE;
  return addChooser(at("chooser"), run.bodies.map((body) => body.name), plots, usage, (body) => {
    swatch.style.background = `rgb(${run.bodies[body].color.map((c) => Math.round(255 * c)).join()})`;
    plots.show(body);
    replay?.select(body);
    at("label").textContent = run.bodies[body].name;
  });
};

// The plots of a body (plots.js).
const plotsOf = (run) => (body) =>
  ({times: run.series.times, groups: chartsOf(run, body, seriesOf(run, body))});

// A column that does not change is a number.
const POSE_COLUMNS = 6;
const firstThatMoves = (run) => Math.max(0, run.series.bodies.findIndex((columns) =>
  columns.slice(0, POSE_COLUMNS).some((column) => typeof column !== "number")));

const run = readRun();
const times = run.poses.times;
const clock = new Clock(times[0], times[times.length - 1]);
showHead(run, at("head"));
const replay = run.bodies.length > 0 ? makeReplay(run, clock) : null;
makeTransport(clock);
if (run.frames) new Strip(run.frames, clock, at("strip"), at("picture"));
makeViews(run, replay);
if (replay) makeToggles(replay);
if (replay && run.rigging) makeTensionScale(run.rigging);
const select = makeChooser(run, new Plots(plotsOf(run), clock, at("charts")), replay);
if (replay) replay.onSelect = select;
showDetails(run, at("details"), select);
select(firstThatMoves(run));
