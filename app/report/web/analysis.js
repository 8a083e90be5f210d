// What `plimsoll analyse` finds of the run (page_data.h): numbers, spectra and responses of the
// selected body, and those of probes and lines.
import uPlot from "uplot";
import {element, number} from "./format.js";
import {isLevel, leastOf, peakOf, shownBins, unitOf} from "./spectra.js";

const HEIGHT = 190;      // px
const WITH_WAVES = 0.05; // of the largest density of the wave: least at which a response is drawn
const MOST_OTHERS = 12;  // rows of probes and lines
const COLORS = ["--c1", "--c2", "--c3", "--c4", "--c5", "--c6", "--c7", "--c8"];

const three = (value) => number(value, 4);

// Texts with a subscript after the underscore.
const HEAD = [
  ["", ""], ["mean", ""], ["std", "standard deviation"], ["least", "and its time"], ["largest", "and its time"],
  ["drift /s", "slope of the line through the signal"], ["cycles", "between upward passages through that line"],
  ["T_z", "mean period of the cycles [s]"], ["H_1/3", "mean height of the highest third of the cycles"],
  ["H_m0", "four times the root of the spectrum's area"], ["T_p", "period of the spectrum's peak [s]"]];
const headOf = ([text, title]) => {
  const [name, below] = text.split("_");
  return element("th", {title}, name, ...(below ? [element("sub", {textContent: below})] : []));
};

const rowOf = (signal, name) => {
  const {statistics: s, spectrum} = signal;
  const head = element("td", {}, element("b", {textContent: name}), ` [${unitOf(signal)}]`);
  if (isLevel(signal))
    return element("tr", {}, head,
                   element("td", {textContent: three(Math.abs(s.mean) <= leastOf(signal) ? 0 : s.mean)}),
                   element("td", {colSpan: HEAD.length - 2, className: "dim", textContent: "does not change"}));
  const when = (value, at) => element("td", {}, three(value),
    element("span", {className: "dim", textContent: ` at ${three(at)} s`}));
  const c = spectrum && s.cycles;
  const cells = [s.mean, s.std].map((v) => element("td", {textContent: three(v)}));
  const rest = [s.drift, c?.count, c?.mean_period, c?.significant_height, spectrum?.significant_height,
                spectrum?.peak_period].map((v) => element("td", {textContent: three(v)}));
  return element("tr", {}, head, ...cells, when(s.min, s.at_min), when(s.max, s.at_max), ...rest);
};

const tableOf = (signals, nameOf) => element("div", {className: "card numbers"}, element("table", {},
  element("tr", {}, ...HEAD.map(headOf)),
  ...signals.map((signal) => rowOf(signal, nameOf(signal)))));

// What a decay tells, in words.
export const decayText = (signal, name) => {
  const {decay: d} = signal;
  return `${name} decays freely to ${three(d.equilibrium)} ${unitOf(signal)}: period ${three(d.period)} s, ` +
    `damping ${number(100 * d.damping_ratio, 3)} % of the critical, ` +
    `quadratic ${number(d.quadratic, 3)} 1/${unitOf(signal)}`;
};

// A plot over the frequency, whose legend has the values at the highest peak or under the cursor.
// lines: [{label, values, dash}]
const chart = ({title, unit, note, lines, step, count, top}, host) => {
  const style = getComputedStyle(document.documentElement);
  const color = (name) => style.getPropertyValue(name).trim();
  const node = element("figure", {className: "chart"},
    element("figcaption", {}, element("b", {textContent: title}), ` [${unit}]`,
            ...(note ? [element("i", {textContent: ` · ${note}`})] : [])));
  host.append(node);
  const axis = {stroke: color("--dim"), grid: {stroke: color("--rule"), width: 1}, ticks: {show: false},
                font: "11px system-ui, sans-serif"};
  const frequencies = Float64Array.from({length: count}, (_, i) => i * step);
  const cut = (values) => Array.from({length: count}, (_, i) => values[i] ?? null);
  const width = () => Math.max(node.clientWidth - 16, 160);
  const columns = lines.map(({values}) => cut(values));
  const rest = (shown) => shown.setLegend({idx: peakOf(columns)}, false);
  const plot = new uPlot({
    width: width(), height: HEIGHT, pxAlign: false, padding: [8, 16, 0, 0],
    cursor: {drag: {x: true, y: false, dist: 4}, points: {size: 6}, y: false},
    scales: {x: {time: false}, y: {range: (_plot, _low, high) => [0, top ?? (high > 0 ? 1.08 * high : 1)]}},
    axes: [{...axis, size: 26, gap: 2, values: (_plot, ticks) => ticks.map((f) => `${number(f)} Hz`)},
           {...axis, size: 52, gap: 4, values: (_plot, ticks) => ticks.map((v) => number(v))}],
    series: [{label: "at", value: (_plot, f) => f > 0 ? `${three(f)} Hz, ${three(1 / f)} s` : "–"},
             ...lines.map(({label, dash}, i) => ({
               label, stroke: color(dash ? "--ink" : COLORS[i % COLORS.length]), width: 1.5, dash,
               points: {show: count <= 40, size: 4}, value: (_plot, v) => three(v)}))],
    hooks: {ready: [(made) => {
      rest(made);
      made.over.addEventListener("mouseleave", () => rest(made));
    }]},
  }, [frequencies, ...columns], node);
  return {plot, fit: () => { if (plot.width !== width()) plot.setSize({width: width(), height: HEIGHT}); }};
};

const spectraOf = (signals, title, unit, nameOf) => {
  const moving = signals.filter((signal) => signal.spectrum && !isLevel(signal));
  if (moving.length === 0) return null;
  const {step, segments} = moving[0].spectrum;
  // Signals of other rows have a spectrum of other frequencies.
  const alike = moving.filter((signal) => signal.spectrum.step === step);
  return {title, unit: `${unit}²/Hz`, step, count: shownBins(alike.map((signal) => signal.spectrum.density)),
          note: segments === 1 ? "one segment" : `mean of ${segments} segments`,
          lines: alike.map((signal) => ({label: nameOf(signal), values: signal.spectrum.density}))};
};

// The wave to which the responses are, beside the spectra of displacements.
const withWave = (spectra, signals) => {
  const {response} = signals.find((signal) => signal.response) ?? {};
  if (!spectra || !response || response.step !== spectra.step) return spectra;
  return {...spectra, count: Math.max(spectra.count, shownBins([response.wave], WITH_WAVES)),
          lines: [...spectra.lines, {label: "wave", values: response.wave, dash: [4, 3]}]};
};

// A response is drawn where the wave has energy.
const withWaves = (response, values) => {
  const top = response.wave.reduce((a, b) => Math.max(a, b), 0);
  return Array.from(values, (v, i) => i > 0 && response.wave[i] >= WITH_WAVES * top ? v : null);
};

const responsesOf = (signals, title, unit, key, top) => {
  const moving = signals.filter((signal) => signal.response && !isLevel(signal));
  if (moving.length === 0) return null;
  const {step, wave} = moving[0].response;
  return {title, unit, step, count: shownBins([wave], WITH_WAVES), top,
          lines: moving.map((signal) => ({label: signal.signal,
                                          values: withWaves(signal.response, signal.response[key])}))};
};

const group = (title, ...parts) =>
  element("details", {open: true, className: "group"}, element("summary", {textContent: title}), ...parts);

export class Analysis {
  // analysis: as data.js has it
  constructor(analysis, host) {
    this.analysis = analysis;
    this.host = host;
    this.charts = [];
    new ResizeObserver(() => { for (const {fit} of this.charts) fit(); }).observe(host);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.show(this.body));
  }

  // @param body   Its name.
  show(body) {
    this.body = body;
    for (const {plot} of this.charts) plot.destroy();
    this.charts = [];
    this.host.replaceChildren();
    const {signals, motions} = this.analysis;
    const own = signals.slice(0, motions).filter((signal) => signal.of === body);
    const others = signals.slice(motions);
    this.addMotions(own);
    if (others.length > 0) this.addOthers(others);
  }

  addMotions(own) {
    const name = (signal) => signal.signal;
    const decays = own.filter((signal) => signal.decay && !isLevel(signal))
      .map((signal) => element("li", {textContent: decayText(signal, name(signal))}));
    const linear = own.slice(0, 3), angular = own.slice(3);
    const grid = element("div", {className: "charts"});
    this.host.append(group("Statistics, spectra and responses", tableOf(own, name),
      ...(decays.length > 0 ? [element("ul", {className: "card decays"}, ...decays)] : []), grid));
    this.draw([
      withWave(spectraOf(linear, "Spectra of displacements", "m", name), linear),
      spectraOf(angular, "Spectra of rotations", "°", name),
      responsesOf(linear, `Response of displacements to ${this.analysis.wave}`, "m/m", "amplitude"),
      responsesOf(angular, `Response of rotations to ${this.analysis.wave}`, "°/m", "amplitude"),
      responsesOf(own, "Coherence with the wave", "1", "coherence", 1.05)], grid);
  }

  addOthers(others) {
    const name = (signal) => `${signal.of} ${signal.signal}`;
    const grid = element("div", {className: "charts"});
    const more = others.length > MOST_OTHERS
      ? [element("p", {className: "note", textContent: `The first ${MOST_OTHERS} of ${others.length}.`})] : [];
    const shown = others.slice(0, MOST_OTHERS);
    this.host.append(group("Probes and lines: statistics and spectra", tableOf(shown, name), ...more, grid));
    const of = (unit) => shown.filter((signal) => signal.unit === unit);
    const short = (signal) => signal.of;
    this.draw([spectraOf(of("m"), "Spectra of elevations", "m", short),
               spectraOf(of("N"), "Spectra of tensions", "N", short)], grid);
  }

  draw(charts, grid) {
    for (const one of charts) if (one) this.charts.push(chart(one, grid));
  }
}
