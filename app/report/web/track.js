// The way of a body seen from above: y over x at one scale, with marks of the time.
import {rowAt} from "./data.js";
import {element, number} from "./format.js";

const HEIGHT = 222;                                     // px
const LONG_HEIGHT = 160;                                // px
const MARGIN = {left: 54, right: 16, top: 10, bottom: 24};  // px
const LONG = 3;        // times as long as wide: a long way
const MARKS = 8;       // about so many marks of the time
const AXIS_GAP = 64;   // px between two numbers of an axis, at least
const LABEL_GAP = 22;  // px between two labels of marks, at least
const SHIP = "M 9 0 L -6 4.5 L -3.5 0 L -6 -4.5 Z";  // its bow is at +x

const svg = (tag, attributes, text = "") => {
  const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.textContent = text;
  return made;
};

// The next of 1, 2, 5, 10, … that is not below `least`.
export const roundStep = (least) => {
  const decade = 10 ** Math.floor(Math.log10(least));
  return [1, 2, 5, 10].map((n) => n * decade).find((step) => step >= least * (1 - 1e-9));
};

const multiples = (step, from, to) => {
  const all = [];
  for (let i = Math.ceil(from / step - 1e-9); i * step <= to + 1e-9 * step; ++i) all.push(i * step);
  return all;
};

const extent = (values) =>
  values.reduce(([low, high], v) => [Math.min(low, v), Math.max(high, v)], [Infinity, -Infinity]);

// Maps metres to pixels of a plot of this size, x and y alike, with the way in its middle.
export const fitted = (x, y, width, height) => {
  const [x0, x1] = extent(x), [y0, y1] = extent(y);
  const scale = Math.min(width / Math.max(x1 - x0, 1e-6), height / Math.max(y1 - y0, 1e-6), 200) * 0.92;
  const middle = [(x0 + x1) / 2, (y0 + y1) / 2];
  return {
    scale,
    x: (value) => width / 2 + scale * (value - middle[0]),
    y: (value) => height / 2 - scale * (value - middle[1]),
    range: [[middle[0] - width / 2 / scale, middle[0] + width / 2 / scale],
            [middle[1] - height / 2 / scale, middle[1] + height / 2 / scale]]};
};

// A way along x is best drawn as wide as the page has room.
export const isLong = ({x, y}) => {
  const [x0, x1] = extent(x), [y0, y1] = extent(y);
  return x1 - x0 > LONG * (y1 - y0);
};

export class Track {
  constructor({title, track, wide}, clock) {
    this.track = track;
    this.times = track.times;
    this.clock = clock;
    this.when = element("span");
    this.height = wide ? LONG_HEIGHT : HEIGHT;
    this.picture = svg("svg", {height: this.height});
    this.node = element("figure", {className: wide ? "chart track wide" : "chart track"},
      element("figcaption", {}, element("b", {textContent: title}), " y over x [m]", this.when), this.picture);
    this.picture.addEventListener("mousemove", (event) => {
      if (this.clock.playing || !this.map) return;
      const box = this.picture.getBoundingClientRect();
      const row = this.nearest(event.clientX - box.left - MARGIN.left, event.clientY - box.top - MARGIN.top);
      this.clock.seek(this.times[row]);
    });
    requestAnimationFrame(() => this.fit());
  }

  fit() {
    const width = this.node.clientWidth - 16;
    if (width <= MARGIN.left + MARGIN.right || width === this.width) return;
    this.width = width;
    this.draw();
    this.mark();
  }

  draw() {
    const {x, y} = this.track;
    const width = this.width - MARGIN.left - MARGIN.right, height = this.height - MARGIN.top - MARGIN.bottom;
    this.map = fitted(x, y, width, height);
    const plot = svg("g", {transform: `translate(${MARGIN.left} ${MARGIN.top})`});
    this.drawAxes(plot, width, height);
    plot.append(svg("path", {class: "path", d: `M ${this.outline(x, y).join(" L ")}`}));
    this.drawMarks(plot, width);
    this.ship = svg("path", {class: "ship", d: SHIP});
    plot.append(this.ship);
    this.picture.replaceChildren(plot);
  }

  // Points of the way in pixels, but for those that are not seen to differ from the one before.
  outline(x, y) {
    const points = [];
    let last = [-Infinity, -Infinity];
    x.forEach((value, i) => {
      const at = [this.map.x(value), this.map.y(y[i])];
      if (i < x.length - 1 && Math.hypot(at[0] - last[0], at[1] - last[1]) < 0.5) return;
      points.push(`${at[0].toFixed(1)} ${at[1].toFixed(1)}`);
      last = at;
    });
    return points;
  }

  drawAxes(plot, width, height) {
    const {map} = this;
    const step = roundStep(AXIS_GAP / map.scale);
    for (const value of multiples(step, ...map.range[0])) {
      const at = map.x(value);
      plot.append(svg("line", {class: "rule", x1: at, x2: at, y1: 0, y2: height}),
                  svg("text", {x: at, y: height + 15, "text-anchor": "middle"}, number(value)));
    }
    for (const value of multiples(step, ...map.range[1])) {
      const at = map.y(value);
      plot.append(svg("line", {class: "rule", x1: 0, x2: width, y1: at, y2: at}),
                  svg("text", {x: -6, y: at + 4, "text-anchor": "end"}, number(value)));
    }
  }

  // Of two marks so near that their labels would overlap the later one has none.
  drawMarks(plot, width) {
    const {times, map, track} = this;
    const end = times[times.length - 1];
    const labelled = [];
    for (const time of multiples(roundStep(Math.max(end - times[0], 1e-9) / MARKS), times[0], end)) {
      const [x, y] = [map.x(this.valueAt(track.x, time)), map.y(this.valueAt(track.y, time))];
      plot.append(svg("circle", {class: "mark", cx: x, cy: y, r: 3}));
      if (labelled.some(([u, v]) => Math.abs(u - x) < 2 * LABEL_GAP && Math.abs(v - y) < LABEL_GAP / 2)) continue;
      labelled.push([x, y]);
      const left = x > width - 2 * LABEL_GAP;
      plot.append(svg("text", {class: "time", x: x + (left ? -7 : 7), y: y - 5,
                               "text-anchor": left ? "end" : "start"}, `${number(time)} s`));
    }
  }

  valueAt(values, time) {
    const row = rowAt(this.times, time), next = Math.min(row + 1, values.length - 1);
    const span = this.times[next] - this.times[row];
    const part = span > 0 ? Math.min(Math.max((time - this.times[row]) / span, 0), 1) : 0;
    return values[row] + part * (values[next] - values[row]);
  }

  nearest(u, v) {
    const {map, track} = this;
    let best = 0, least = Infinity;
    track.x.forEach((x, i) => {
      const distance = (map.x(x) - u) ** 2 + (map.y(track.y[i]) - v) ** 2;
      if (distance < least) [best, least] = [i, distance];
    });
    return best;
  }

  // The body at the time of the replay.
  mark() {
    if (!this.map) return;
    const {time} = this.clock;
    const [x, y, heading] = [this.track.x, this.track.y, this.track.heading]
      .map((values) => this.valueAt(values, time));
    this.ship.setAttribute("transform",
      `translate(${this.map.x(x)} ${this.map.y(y)}) rotate(${-heading})`);
    this.when.textContent = `x ${number(x, 4)}, y ${number(y, 4)}, heading ${number(heading, 3)}°`;
  }
}
