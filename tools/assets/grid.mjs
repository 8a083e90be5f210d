/** Items in a grid of cells, to find the one nearest to a point. */
export class Grid {
  constructor(cell) {
    this.cell = cell;
    this.cells = new Map();
    this.widest = 0;
  }

  key(i, j, k) {
    return ((i + 1024) * 2048 + (j + 1024)) * 2048 + (k + 1024);
  }

  insert(item, points) {
    const low = [0, 1, 2].map((k) => Math.floor(Math.min(...points.map((p) => p[k])) / this.cell));
    const high = [0, 1, 2].map((k) => Math.floor(Math.max(...points.map((p) => p[k])) / this.cell));
    for (let i = low[0]; i <= high[0]; ++i) {
      for (let j = low[1]; j <= high[1]; ++j) {
        for (let k = low[2]; k <= high[2]; ++k) this.put(this.key(i, j, k), item);
      }
    }
  }

  put(key, item) {
    if (!this.cells.has(key)) this.cells.set(key, []);
    this.cells.get(key).push(item);
  }

  /** The least of `measure(item)`, an object with a `distance` to p, over all items. */
  nearest(p, measure) {
    const centre = p.map((x) => Math.floor(x / this.cell));
    let best = {distance: Infinity};
    for (let shell = 0; best.distance > (shell - 1) * this.cell; ++shell) {
      if (shell > 1000) throw new Error('no surface near a point');
      for (const item of this.shell(centre, shell)) {
        const found = measure(item);
        if (found.distance < best.distance) best = found;
      }
    }
    return best;
  }

  * shell([ci, cj, ck], r) {
    for (let i = -r; i <= r; ++i) {
      for (let j = -r; j <= r; ++j) {
        const inside = Math.abs(i) < r && Math.abs(j) < r;
        for (let k = -r; k <= r; k += inside && r > 0 ? 2 * r : 1) {
          yield* this.cells.get(this.key(ci + i, cj + j, ck + k)) ?? [];
        }
      }
    }
  }
}
