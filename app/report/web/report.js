// The page of a run: everything on it shows the time of one clock and one selected body.
import "./style.css";
import {Analysis} from "./analysis.js";
import {chartsOf} from "./charts.js";
import {addChooser, USAGE} from "./chooser.js";
import {Clock} from "./clock.js";
import {readRun, seriesOf} from "./data.js";
import {showDetails, showHead} from "./facts.js";
import {at, element, grouped, number, prefixOf} from "./format.js";
import {Plots} from "./plots.js";
import {makeReplay, makeToggles, makeTransport, makeViews} from "./stage.js";
import {Strip} from "./strip.js";

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
const makeChooser = (run, plots, analysis, replay) => {
  const swatch = element("i", {className: "swatch"});
  at("chooser").append(swatch);
  const usage = run.series.thinned
    ? `${grouped(run.series.times.length)} of ${grouped(run.rows)} rows: least and largest of each interval`
    : USAGE;
  return addChooser(at("chooser"), run.bodies.map((body) => body.name), plots, usage, (body) => {
    swatch.style.background = `rgb(${run.bodies[body].color.map((c) => Math.round(255 * c)).join()})`;
    plots.show(body);
    analysis?.show(run.bodies[body].name);
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
const analysis = run.analysis ? new Analysis(run.analysis, at("analysis")) : null;
const select = makeChooser(run, new Plots(plotsOf(run), clock, at("charts")), analysis, replay);
if (replay) replay.onSelect = select;
showDetails(run, at("details"), select);
select(firstThatMoves(run));
