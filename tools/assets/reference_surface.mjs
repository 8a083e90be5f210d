// A fine closed surface as the remesher sees it: smooth regions that meet in creases, how long
// edges should be where, and the point of a region or of a crease nearest to a given point.
import {Grid} from './grid.mjs';
import {vertex_metrics, weighted_metric} from './sizing.mjs';
import {area_vector, closest_on_segment, closest_on_triangle} from './vectors.mjs';
import {cross, distance, dot, norm, sub, unit} from './vectors.mjs';

// Two faces that turn by more than this [rad] meet in a sharp edge. Larger loses the kink under the
// teapot's knob (0.64), smaller finds edges in the finely curved rim.
const kSharp = 0.45;

const edge_key = (a, b) => (a < b ? a * 2 ** 26 + b : b * 2 ** 26 + a);

/** Map from each edge to the two faces it has; throws where there are not two. */
function edge_faces(faces) {
  const edges = new Map();
  faces.forEach((face, f) => {
    for (let k = 0; k < 3; ++k) {
      const key = edge_key(face[k], face[(k + 1) % 3]);
      if (!edges.has(key)) edges.set(key, []);
      edges.get(key).push(f);
    }
  });
  for (const sides of edges.values()) {
    if (sides.length !== 2)
      throw new Error(`an edge of the fine surface has ${sides.length} faces`);
  }
  return edges;
}

const edge_ends = (key) => [Math.floor(key / 2 ** 26), key % 2 ** 26];

/**
 * Number of the smooth region each face lies in, found by walking over all edges but the sharp
 * ones.
 */
function smooth_regions(faces, edges, is_sharp) {
  const neighbours = faces.map(() => []);
  for (const [key, [f, g]] of edges) {
    if (is_sharp(key, f, g)) continue;
    neighbours[f].push(g);
    neighbours[g].push(f);
  }
  const region = new Array(faces.length).fill(-1);
  let count = 0;
  for (let seed = 0; seed < faces.length; ++seed) {
    if (region[seed] >= 0) continue;
    const open = [seed];
    region[seed] = count;
    while (open.length > 0) {
      for (const g of neighbours[open.pop()]) {
        if (region[g] < 0) region[g] = count, open.push(g);
      }
    }
    ++count;
  }
  return region;
}

/** Whether an edge joins two vertices of one ridge, as a function of the edge's key. */
function ridge_edges(positions, ridges) {
  const ridge_at = new Map();
  ridges.forEach((points, r) => points.forEach((p) => ridge_at.set(place(p), r)));
  const ridge = positions.map((p) => ridge_at.get(place(p)));
  return (key) => {
    const [a, b] = edge_ends(key);
    return ridge[a] !== undefined && ridge[a] === ridge[b];
  };
}

/** A point as single precision holds it, as text; -0 and 0 are the same. */
const place = (p) => p.map((x) => Math.fround(x) + 0).join(' ');

/** Name of the creases between two regions. */
export const crease_name = (regions) => regions.join(' ');

export class ReferenceSurface {
  /**
   * `sizing` as in sizing.mjs. `ridges`: lists of vertices, each list a line over the surface that
   * becomes a crease though the surface is smooth there, for it bends more tightly than edges are
   * long.
   */
  constructor(mesh, ridges, sizing) {
    this.positions = mesh.positions;
    this.faces = mesh.faces;
    const edges = edge_faces(mesh.faces), on_ridge = ridge_edges(mesh.positions, ridges);
    const normals =
        mesh.faces.map((face) => unit(area_vector(...face.map((v) => mesh.positions[v]))));
    const is_sharp = (key, f, g) => dot(normals[f], normals[g]) < Math.cos(kSharp) || on_ridge(key);
    this.region = smooth_regions(mesh.faces, edges, is_sharp);
    const listed = [...edges].map(([key, sides]) => ({ends: edge_ends(key), sides}));
    this.metrics = vertex_metrics(mesh, listed, this.region, sizing);
    this.index_regions(sizing.longest / 4);
    this.index_creases(edges);
  }

  index_regions(cell) {
    this.grids = Array.from({length: Math.max(...this.region) + 1}, () => new Grid(cell));
    this.faces.forEach((face, f) => {
      this.grids[this.region[f]].insert(f, face.map((v) => this.positions[v]));
    });
  }

  index_creases(edges) {
    this.creases = new Map();
    for (const [key, sides] of edges) {
      const regions = sides.map((f) => this.region[f]).sort((a, b) => a - b);
      if (regions[0] === regions[1]) continue;
      const name = crease_name(regions);
      if (!this.creases.has(name)) this.creases.set(name, []);
      this.creases.get(name).push(edge_ends(key));
    }
  }

  /** Nearest point of a region: {point, metric there}. */
  on_region(p, region) {
    const found = this.grids[region].nearest(p, (f) => {
      const point = closest_on_triangle(p, ...this.faces[f].map((v) => this.positions[v]));
      return {distance: distance(p, point), point, f};
    });
    return {point: found.point, metric: this.metric_in(found.f, found.point)};
  }

  /** Nearest point of the creases between two regions: {point, metric there}. */
  on_crease(p, regions) {
    let best = {distance: Infinity};
    for (const [a, b] of this.creases.get(crease_name(regions))) {
      const point = closest_on_segment(p, this.positions[a], this.positions[b]);
      const away = distance(p, point);
      if (away < best.distance) best = {distance: away, point, metric: this.metrics[a]};
    }
    return best;
  }

  /** The metric inside a face, linear between its corners. */
  metric_in(f, p) {
    const face = this.faces[f], [a, b, c] = face.map((v) => this.positions[v]);
    const parts =
        [[p, b, c], [a, p, c], [a, b, p]].map(([u, v, w]) => norm(cross(sub(v, u), sub(w, u))));
    const whole = parts[0] + parts[1] + parts[2];
    if (!(whole > 0)) return this.metrics[face[0]];
    return weighted_metric(face.map((v) => this.metrics[v]), parts.map((part) => part / whole));
  }
}
