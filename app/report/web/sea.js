// Height of the water's surface above its level on a square grid, as hydro/sea.h has it.

const COMPONENT = 5;       // amplitude, kx, ky, omega, phase
const LEAST_CELLS = 2.5;   // to a wave that the grid can show

// A sum of waves: the phases along x and along y are found once for a place of the grid, so that a
// time costs two multiplications a wave and point.
class Waves {
  constructor(components, ramp, count) {
    this.components = components;
    this.ramp = ramp;
    this.count = count;
    this.number = components.length / COMPONENT;
    const table = () => new Float64Array(this.number * count);
    this.along = {cosX: table(), sinX: table(), cosY: table(), sinY: table()};
  }

  place(x0, y0, cell) {
    const {cosX, sinX, cosY, sinY} = this.along;
    this.shown = [];
    for (let w = 0; w < this.number; ++w) {
      const [, kx, ky] = this.components.subarray(COMPONENT * w, COMPONENT * (w + 1));
      if (Math.hypot(kx, ky) * cell * LEAST_CELLS > 2 * Math.PI) continue;
      this.shown.push(w);
      for (let i = 0; i < this.count; ++i) {
        const x = kx * (x0 + i * cell), y = ky * (y0 + i * cell);
        const k = w * this.count + i;
        cosX[k] = Math.cos(x); sinX[k] = Math.sin(x);
        cosY[k] = Math.cos(y); sinY[k] = Math.sin(y);
      }
    }
  }

  // Of the amplitudes at a time, as amplitude_factor of hydro/sea.h.
  factor(time) {
    if (this.ramp <= 0 || time >= this.ramp) return 1;
    return time <= 0 ? 0 : (1 - Math.cos(Math.PI * time / this.ramp)) / 2;
  }

  heights(time, out) {
    const {cosX, sinX, cosY, sinY} = this.along;
    const n = this.count;
    const factor = this.factor(time);
    out.fill(0);
    for (const w of this.shown) {
      const [whole, , , omega, phase] = this.components.subarray(COMPONENT * w, COMPONENT * (w + 1));
      const a = factor * whole;
      const c0 = a * Math.cos(phase - omega * time), s0 = a * Math.sin(phase - omega * time);
      for (let j = 0; j < n; ++j) {
        const c = c0 * cosY[w * n + j] - s0 * sinY[w * n + j];
        const s = s0 * cosY[w * n + j] + c0 * sinY[w * n + j];
        for (let i = 0; i < n; ++i)
          out[j * n + i] += c * cosX[w * n + i] - s * sinX[w * n + i];
      }
    }
  }
}

// Heights at points, bilinear; beyond their grid those of the nearest edge.
class Field {
  constructor(water, count) {
    this.water = water;
    this.count = count;
    this.still = new Float64Array(count * count);
  }

  place(x0, y0, cell) {
    const {rows, columns, cell: own, origin, heights} = this.water;
    const along = (s, last) => {
      const at = Math.min(Math.max(s, 0), last);
      const index = Math.min(Math.floor(at), Math.max(last - 1, 0));
      return [index, Math.min(index + 1, last), at - index];
    };
    for (let j = 0; j < this.count; ++j)
      for (let i = 0; i < this.count; ++i) {
        const [c0, c1, u] = along((x0 + i * cell - origin[0]) / own, columns - 1);
        const [r0, r1, v] = along((y0 + j * cell - origin[1]) / own, rows - 1);
        const h = (r, c) => heights[r * columns + c];
        this.still[j * this.count + i] =
          (1 - v) * ((1 - u) * h(r0, c0) + u * h(r0, c1)) + v * ((1 - u) * h(r1, c0) + u * h(r1, c1));
      }
  }

  heights(_time, out) { out.set(this.still); }
}

class Flat {
  place() {}
  heights(_time, out) { out.fill(0); }
}

// A grid of count × count points: place(x0, y0, cell) puts its first point there in the world, and
// heights(time, out) fills `out` row by row, row = y.
export const makeSea = (water, count) => {
  if (water.kind === "waves") return new Waves(water.components, water.ramp, count);
  if (water.kind === "heightfield") return new Field(water, count);
  return new Flat();
};
