// Plots of the selected body over time, with one cursor and one zoom for all.
import uPlot from "uplot";
import {rowAt} from "./data.js";
import {flatBounds, largestOf, leastOf, spreadOf} from "./extent.js";
import {decimalsOf, element, fixed, number, prefixOf} from "./format.js";
import {Track} from "./track.js";

const HEIGHT = 190;    // px
const FEW_LINES = 3;   // whose legend fits in one line
const MOST_DOTS = 40;  // rows in sight up to which each is marked
const FEW_DIGITS = 4;  // of values whose sizes are far apart

// Of [N], [N m] and [J]: the prefix by which the largest number is written shortly.
const scaleOf = (chart) => {
  if (!chart.prefixed) return [1, chart.unit];
  const [factor, letter] = prefixOf(largestOf(chart));
  return [factor, letter + chart.unit];
};

// Bounds of y that do not blow up what is constant but for rounding.
const bounds = (least) => (_plot, low, high) =>
  low === null ? [-1, 1] : flatBounds(low, high, least) ?? uPlot.rangeNum(low, high, 0.08, true);

// Whole decades, where there is anything above zero.
const decades = (_plot, low, high) => low === null ? [0.1, 1] : uPlot.rangeLog(low, high, 10, true);

// Of the marks of a logarithmic axis those that have a line: one a decade.
const ofDecades = (_plot, marks) => marks.map((v) => Math.abs(Math.log10(v) % 1) < 1e-6 ? v : null);

// From zero, for what is never below it.
const upwards = (_plot, _low, high) => [0, high > 0 ? 1.08 * high : 1];

// The time axis; that of a single row has a length all the same.
const span = (_plot, from, to) => from === to ? [from - 0.5, to + 0.5] : [from, to];

// A chart: {title, unit, lines: [{label, color, values, dash, width}]}, and where it has them
// `prefixed`: a unit that takes prefixes, `log`: a logarithmic scale, `fromZero`: one from 0,
// `least`: the change below which a line is level, `moments`: [{time, text}] that a line marks, `note`: a text behind the title, `wide`: the whole
// row. A chart with a `track` is no plot over time (track.js).
export class Plots {
  // @param plotsOf   of a body: {times, groups: [{title, charts, bad}]}
  constructor(plotsOf, clock, host) {
    this.plotsOf = plotsOf;
    this.clock = clock;
    this.host = host;
    this.zoom = null;     // [from, to], null: the whole run
    this.hidden = new Set();  // labels of lines that are switched off
    this.cards = [];
    this.tracks = [];
    this.onZoom = () => {};
    this.sync = uPlot.sync("time");
    this.watcher = new IntersectionObserver((entries) => {
      for (const entry of entries) {
        const card = entry.target.card;
        card.inSight = entry.isIntersecting;
        if (card.inSight && !card.plot) this.draw(card);
        else if (card.inSight) this.mark(card);
      }
    }, {rootMargin: "300px"});
    new ResizeObserver(() => this.fit()).observe(host);
    clock.onChange(() => this.markAll());
    addEventListener("beforeprint", () => {
      for (const card of this.cards) if (!card.plot) this.draw(card);
    });
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.redraw());
  }

  show(body) {
    for (const card of this.cards) { card.plot?.destroy(); this.watcher.unobserve(card.node); }
    this.cards = [];
    this.tracks = [];
    this.host.replaceChildren();
    const {times, groups} = this.plotsOf(body);
    this.times = times;
    for (const group of groups) {
      const grid = element("div", {className: "charts"});
      const title = element("summary", {textContent: group.title, className: group.bad ? "bad" : ""});
      this.host.append(element("details", {open: true, className: "group"}, title, grid));
      for (const chart of group.charts) if (chart.track) this.addTrack(chart, grid); else this.addCard(chart, grid);
    }
  }

  addTrack(chart, grid) {
    const track = new Track(chart, this.clock);
    this.tracks.push(track);
    grid.append(track.node);
  }

  addCard(chart, grid) {
    const [factor, unit] = scaleOf(chart);
    const when = element("span");
    const many = chart.lines.length > FEW_LINES ? " many" : "";
    const node = element("figure", {className: `chart${many}${chart.wide ? " wide" : ""}`},
      element("figcaption", {}, element("b", {textContent: chart.title}), ` [${unit}]`, when,
                ...(chart.note ? [element("i", {textContent: ` · ${chart.note}`})] : [])));
    const least = leastOf(chart) / factor, spread = spreadOf(chart) / factor;
    const decimals = decimalsOf(spread >= least ? spread : largestOf(chart) / factor);
    const card = {chart, decimals, least, node, when, inSight: false};
    card.data = [this.times,
                 ...chart.lines.map((line) => line.values.map((value) => value === null ? null : value / factor))];
    node.card = card;
    this.cards.push(card);
    grid.append(node);
    this.watcher.observe(node);
  }

  draw(card) {
    const style = getComputedStyle(document.documentElement);
    const ink = style.getPropertyValue("--dim").trim(), rule = style.getPropertyValue("--rule").trim();
    const axis = {stroke: ink, grid: {stroke: rule, width: 1}, ticks: {show: false},
                  font: "11px system-ui, sans-serif"};
    const {log, fromZero} = card.chart;
    const value = (_plot, v) => log || fromZero ? number(v, FEW_DIGITS) : fixed(v, card.decimals);
    card.plot = new uPlot({
      width: this.widthOf(card), height: HEIGHT, pxAlign: false,
      padding: [8, 16, 0, 0],
      cursor: {sync: {key: this.sync.key, setSeries: false}, drag: {x: true, y: false, dist: 4},
               points: {size: 6}, y: false},
      legend: {live: true},
      scales: {x: {time: false, range: span},
               y: log ? {distr: 3, range: decades} : {range: fromZero ? upwards : bounds(card.least)}},
      axes: [{...axis, size: 26, gap: 2, values: (_plot, ticks) => ticks.map((t) => `${number(t)} s`)},
             {...axis, grid: log ? {...axis.grid, filter: ofDecades} : axis.grid, size: 52, gap: 4,
              values: (_plot, ticks) => ticks.map((v) => v === null ? "" : number(v))}],
      series: [{label: "time"},
               ...card.chart.lines.map((line) => ({
                 label: line.label,
                 stroke: style.getPropertyValue(line.color).trim(),
                 width: line.width ?? 1.5,
                 dash: line.dash,
                 show: !this.hidden.has(line.label),
                 points: {show: (plot, _i, from, to) => to - from <= MOST_DOTS && plot.width > 0, size: 4},
                 value}))],
      hooks: {
        ready: [(plot) => { card.plot = plot; this.begin(card); }],
        setScale: [(plot, key) => { if (key === "x") this.follow(plot); }],
        setLegend: [(plot) => {
          const t = this.times[plot.legend.idx ?? -1];
          card.when.textContent = t === undefined ? "" : `at ${number(t, 6)} s`;
        }],
        setSeries: [(plot, i, options) => {
          if (options.show === undefined || i === null || i === 0) return;
          const label = plot.series[i].label;
          if (options.show) this.hidden.delete(label); else this.hidden.add(label);
        }],
      },
    }, card.data, card.node);
  }

  // What a plot has beyond uPlot's own, once it is drawn.
  begin(card) {
    const {plot} = card;
    card.now = element("div", {className: "now"});
    card.moments = (card.chart.moments ?? []).map(({time, text}) =>
      ({time, node: element("div", {className: "moment", title: text})}));
    plot.over.append(card.now, ...card.moments.map(({node}) => node));
    plot.over.addEventListener("mousemove", (event) => {
      if (!this.clock.playing && event.buttons === 0) this.clock.seek(plot.posToVal(event.offsetX, "x"));
    });
    plot.over.addEventListener("mouseleave", () => this.markAll());
    if (this.zoom) {
      this.quiet = true;
      plot.setScale("x", {min: this.zoom[0], max: this.zoom[1]});
      queueMicrotask(() => { this.quiet = false; });
    }
    this.mark(card);
  }

  // The zoom of one plot becomes that of all.
  follow(plot) {
    if (this.quiet) return;
    const {min, max} = plot.scales.x;
    const {times} = this;
    const whole = min <= times[0] && max >= times[times.length - 1];
    if (this.zoom === null && whole) return;
    this.setZoom(whole ? null : [min, max], plot);
  }

  setZoom(zoom, except) {
    this.zoom = zoom;
    const {times} = this;
    const [min, max] = zoom ?? [times[0], times[times.length - 1]];
    this.quiet = true;
    for (const {plot} of this.cards) if (plot && plot !== except) plot.setScale("x", {min, max});
    queueMicrotask(() => { this.quiet = false; this.markAll(); });
    this.onZoom(zoom);
  }

  markAll() {
    for (const track of this.tracks) track.mark();
    for (const card of this.cards) if (card.inSight && card.plot) this.mark(card);
  }

  // The time of the replay: a line, and the values there in the legend.
  mark(card) {
    const {plot} = card;
    if (!card.now) return;
    const place = (node, time) => {
      const x = plot.valToPos(time, "x");
      const inside = x >= 0 && x <= plot.over.clientWidth;
      node.style.display = inside ? "" : "none";
      node.style.transform = `translateX(${x}px)`;
    };
    place(card.now, this.clock.time);
    for (const {node, time} of card.moments) place(node, time);
    if (plot.over.matches(":hover")) return;
    plot.setLegend({idx: rowAt(this.times, this.clock.time + 1e-9)}, false);
    card.when.textContent = "";
  }

  widthOf(card) { return Math.max(card.node.clientWidth - 16, 160); }

  fit() {
    for (const track of this.tracks) track.fit();
    for (const card of this.cards)
      if (card.plot && card.plot.width !== this.widthOf(card)) {
        card.plot.setSize({width: this.widthOf(card), height: HEIGHT});
        this.mark(card);
      }
  }

  redraw() {
    for (const card of this.cards) {
      card.plot?.destroy();
      card.plot = card.now = null;
      if (card.inSight) this.draw(card);
    }
  }
}
