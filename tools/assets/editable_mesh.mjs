// A closed triangle mesh that can be changed edge by edge and stays a closed two-manifold.
// Every face carries the region it lies in; where regions differ across an edge, the edge is a
// crease.
import {metric_product, weighted_metric} from './sizing.mjs';
import {area_vector, dot, middle, sub, unit} from './vectors.mjs';

// Least cosine between a face's normal before and after a change; below, the surface would fold.
const kLeastTurn = 0.5;

export class EditableMesh {
  /** `metrics`: the metric wished at each vertex, as in sizing.mjs. */
  constructor(positions, faces, regions, metrics) {
    this.positions = positions.slice();
    this.faces = faces.map((face) => face.slice());
    this.region = regions.slice();
    this.metrics = metrics.slice();
    this.around = positions.map(() => []);
    this.faces.forEach((face, f) => face.forEach((v) => this.around[v].push(f)));
  }

  /** All edges [a, b] with a < b, in a fixed order. */
  edges() {
    const list = [];
    this.faces.forEach((face) => {
      if (!face) return;
      for (let k = 0; k < 3; ++k) {
        if (face[k] < face[(k + 1) % 3]) list.push([face[k], face[(k + 1) % 3]]);
      }
    });
    return list;
  }

  /** The faces on both sides of edge a-b; none when there is no such edge. */
  sides(a, b) {
    return this.around[a].filter((f) => this.faces[f].includes(b));
  }

  /** The corner of face f that is neither a nor b. */
  opposite(f, a, b) {
    return this.faces[f].find((v) => v !== a && v !== b);
  }

  /**
   * Sorted numbers of the regions that meet at a vertex: one is smooth, two a crease, more a
   * corner.
   */
  regions_at(v) {
    return [...new Set(this.around[v].map((f) => this.region[f]))].sort((a, b) => a - b);
  }

  is_crease(a, b) {
    const [f, g] = this.sides(a, b);
    return this.region[f] !== this.region[g];
  }

  neighbours(v) {
    return [...new Set(this.around[v].flatMap((f) => this.faces[f]))].filter((w) => w !== v);
  }

  normal(face) {
    return unit(area_vector(...face.map((v) => this.positions[v])));
  }

  /** Length of an edge over the wished one. */
  relative_length(a, b) {
    const d = sub(this.positions[b], this.positions[a]);
    const square = (v) => metric_product(this.metrics[v], d, d);
    return Math.sqrt((square(a) + square(b)) / 2);
  }

  /** Twice the area and the least angle [rad] of a face as its metric sees them. */
  relative_shape(face) {
    const metric = weighted_metric(face.map((v) => this.metrics[v]), [1 / 3, 1 / 3, 1 / 3]);
    const [a, b, c] = face.map((v) => this.positions[v]);
    const at = (p, q, r) => {
      const u = sub(q, p), v = sub(r, p), product = metric_product(metric, u, v);
      const squares = metric_product(metric, u, u) * metric_product(metric, v, v);
      const area = Math.sqrt(Math.max(0, squares - product * product));
      return {area, angle: Math.atan2(area, product)};
    };
    const corners = [at(a, b, c), at(b, c, a), at(c, a, b)];
    return {area: corners[0].area, least_angle: Math.min(...corners.map((corner) => corner.angle))};
  }

  /** Whether faces keep their direction when vertex v moves to p; `except` are about to vanish. */
  may_move(v, p, except = []) {
    const before = this.positions[v];
    const kept = this.around[v].filter((f) => !except.includes(f));
    const normals = kept.map((f) => this.normal(this.faces[f]));
    this.positions[v] = p;
    const fine = kept.every((f, i) => dot(this.normal(this.faces[f]), normals[i]) >= kLeastTurn);
    this.positions[v] = before;
    return fine;
  }

  add_face(face, region) {
    const f = this.faces.push(face) - 1;
    this.region.push(region);
    face.forEach((v) => this.around[v].push(f));
  }

  remove_face(f) {
    this.faces[f].forEach((v) => {
      this.around[v] = this.around[v].filter((g) => g !== f);
    });
    this.faces[f] = null;
  }

  replace_vertex(f, from, to) {
    const region = this.region[f], face = this.faces[f].map((v) => (v === from ? to : v));
    this.remove_face(f);
    this.add_face(face, region);
  }

  /** A new vertex in the middle of edge a-b. */
  split(a, b) {
    const m = this.positions.push(middle(this.positions[a], this.positions[b])) - 1;
    this.metrics.push(weighted_metric([this.metrics[a], this.metrics[b]], [0.5, 0.5]));
    this.around.push([]);
    for (const f of this.sides(a, b)) {
      const face = this.faces[f], region = this.region[f];
      this.remove_face(f);
      this.add_face(face.map((v) => (v === b ? m : v)), region);
      this.add_face(face.map((v) => (v === a ? m : v)), region);
    }
    return m;
  }

  /**
   * Whether drawing `gone` into `kept` leaves a two-manifold: they share exactly two neighbours.
   */
  may_collapse(gone, kept) {
    const near = this.neighbours(kept);
    const shared = this.neighbours(gone).filter((v) => near.includes(v));
    return shared.length === 2 && shared.every((v) => this.around[v].length > 3);
  }

  collapse(gone, kept) {
    for (const f of this.sides(gone, kept)) this.remove_face(f);
    for (const f of this.around[gone].slice()) this.replace_vertex(f, gone, kept);
  }

  /**
   * The two faces that would replace those of edge a-b, or null where the edge cannot be turned.
   */
  flipped(a, b) {
    const [f, g] = this.sides(a, b);
    if (this.region[f] !== this.region[g]) return null;
    const c = this.opposite(f, a, b), d = this.opposite(g, a, b);
    if (this.around[a].length <= 3 || this.around[b].length <= 3 || this.sides(c, d).length > 0)
      return null;
    const face = this.faces[f];
    const forward = face[(face.indexOf(a) + 1) % 3] === b;
    return forward ? [[a, d, c], [d, b, c]] : [[b, d, c], [d, a, c]];
  }

  flip(a, b, replacement) {
    const [f, g] = this.sides(a, b), region = this.region[f];
    this.remove_face(f);
    this.remove_face(g);
    replacement.forEach((face) => this.add_face(face, region));
  }

  /** Faces and vertices still in use, vertices renumbered in order of first use. */
  compact(keep_region = () => true) {
    const number = new Map(), positions = [], faces = [];
    this.faces.forEach((face, f) => {
      if (!face || !keep_region(this.region[f])) return;
      faces.push(face.map((v) => {
        if (!number.has(v)) number.set(v, positions.push(this.positions[v]) - 1);
        return number.get(v);
      }));
    });
    return {positions, faces};
  }
}
