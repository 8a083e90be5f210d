// How long edges should be on a surface. The wish at a point is a metric: a symmetric matrix M,
// kept as [xx, yy, zz, xy, xz, yz], in which an edge d of the wished length has d·M d = 1. Where a
// surface bends in one direction only, as a tube does, edges along the tube may be longer than
// those around it.
//
// A sizing is {error, shortest, longest, finest, stretch, gradation}, the first four in metres: how
// far a triangle may depart from the surface, the range of edge lengths, the length below which an
// edge of the fine surface tells no curvature; the greatest ratio of edge lengths at one point, and
// by how much edge lengths may change over a unit of distance, so that neighbouring triangles are
// of similar size.
import {add, angles, area_vector, cross, distance, dot} from './vectors.mjs';
import {scale, sub, unit} from './vectors.mjs';

/** d·M e */
export function metric_product(m, d, e) {
  return m[0] * d[0] * e[0] + m[1] * d[1] * e[1] + m[2] * d[2] * e[2] +
      m[3] * (d[0] * e[1] + d[1] * e[0]) + m[4] * (d[0] * e[2] + d[2] * e[0]) +
      m[5] * (d[1] * e[2] + d[2] * e[1]);
}

export function weighted_metric(metrics, weights) {
  return metrics[0].map((_, k) => metrics.reduce((sum, m, i) => sum + weights[i] * m[k], 0));
}

/** The metric that wishes `short` everywhere but `long` in the direction `along`. */
function metric_of({short, long, along: a}) {
  const p = 1 / short ** 2, q = 1 / long ** 2 - p;
  return [
    p + q * a[0] * a[0], p + q * a[1] * a[1], p + q * a[2] * a[2], q * a[0] * a[1], q * a[0] * a[2],
    q * a[1] * a[2]
  ];
}

/** Smooth normals, one for each vertex and region it touches, by region and vertex. */
function vertex_normals({positions, faces}, region) {
  const sums = Array.from({length: Math.max(...region) + 1}, () => new Map());
  faces.forEach((face, f) => {
    const corners = face.map((v) => positions[v]), normal = unit(area_vector(...corners));
    const of_region = sums[region[f]];
    angles(...corners).forEach((angle, k) => {
      of_region.set(face[k], add(of_region.get(face[k]) ?? [0, 0, 0], scale(angle, normal)));
    });
  });
  sums.forEach((of_region) => of_region.forEach((sum, v) => of_region.set(v, unit(sum))));
  return sums;
}

/** Solution of the symmetric system with rows (a, b, 0), (b, a + c, b), (0, b, c). */
function solve_bending([a, b, c], [p, q, r]) {
  const minor = (a + c) * c - b * b, determinant = a * minor - b * b * c;
  if (!(Math.abs(determinant) > 1e-9 * (a + c) ** 3)) return null;
  return [
    (p * minor - b * (q * c - r * b)) / determinant,
    (a * (q * c - b * r) - b * p * c) / determinant,
    (a * ((a + c) * r - b * q) - b * b * r + b * b * p) / determinant,
  ];
}

/**
 * Principal curvatures {most, least, along} at a vertex, from the turn of the normal along its
 * edges: least squares for the matrix (e, f; f, g) in the tangent plane (Rusinkiewicz, Estimating
 * curvatures and their derivatives on triangle meshes, 2004). `along` is the direction that bends
 * least.
 */
function curvatures(normal, edges) {
  const u = unit(cross(normal, Math.abs(normal[0]) < 0.6 ? [1, 0, 0] : [0, 1, 0])),
        v = cross(normal, u);
  const left = [0, 0, 0], right = [0, 0, 0];
  for (const {step, turn} of edges) {
    const span = Math.hypot(dot(step, u), dot(step, v));
    const x = dot(step, u) / span, y = dot(step, v) / span, a = dot(turn, u) / span,
          b = dot(turn, v) / span;
    [x * x, x * y, y * y].forEach((term, k) => {
      left[k] += term;
    });
    [x * a, y * a + x * b, y * b].forEach((term, k) => {
      right[k] += term;
    });
  }
  const solution = edges.length >= 2 ? solve_bending(left, right) : null;
  if (!solution) return {most: 0, least: 0, along: u};
  const [e, f, g] = solution, mean = (e + g) / 2, spread = Math.hypot((e - g) / 2, f);
  const angle = 0.5 * Math.atan2(2 * f, e - g) + (mean > 0 ? Math.PI / 2 : 0);
  const along = add(scale(Math.cos(angle), u), scale(Math.sin(angle), v));
  return {most: Math.abs(mean) + spread, least: Math.abs(Math.abs(mean) - spread), along};
}

/** Length of an edge whose triangle departs by `error` from a circle of the given curvature. */
function length_for(curvature, {error, shortest, longest}) {
  const radius = 1 / Math.max(curvature, 1e-9);
  const length = Math.sqrt(Math.max(0, 6 * error * radius - 3 * error * error));
  return Math.min(longest, Math.max(shortest, length));
}

/** The edges that leave each vertex inside a region, with the turn of the normal along them. */
function bending_edges({positions}, edges, region, normals, finest) {
  const lists = normals.map(() => new Map());
  const put = (r, a, b) => {
    const step = sub(positions[b], positions[a]);
    if (!lists[r].has(a)) lists[r].set(a, []);
    lists[r].get(a).push({step, turn: sub(normals[r].get(b), normals[r].get(a))});
  };
  for (const {ends: [a, b], sides: [f, g]} of edges) {
    if (region[f] !== region[g] || distance(positions[a], positions[b]) < finest) continue;
    put(region[f], a, b);
    put(region[f], b, a);
  }
  return lists;
}

/** {short, long, along} at each vertex; where regions meet, of the region that bends most. */
function wished_lengths(mesh, edges, region, sizing) {
  const normals = vertex_normals(mesh, region);
  const wishes =
      mesh.positions.map(() => ({short: sizing.longest, long: sizing.longest, along: [1, 0, 0]}));
  bending_edges(mesh, edges, region, normals, sizing.finest)
      .forEach((list, r) => list.forEach((steps, v) => {
        const {most, least, along} = curvatures(normals[r].get(v), steps);
        const short = length_for(most, sizing);
        if (short < wishes[v].short) wishes[v] = {short, long: length_for(least, sizing), along};
      }));
  return wishes;
}

/** The largest lengths not above the given ones that change no faster than `gradation`. */
function graded(lengths, positions, edges, gradation) {
  const result = lengths.slice();
  const spans =
      edges.map(({ends: [a, b]}) => [a, b, gradation * distance(positions[a], positions[b])]);
  for (let changed = true; changed;) {
    changed = false;
    for (const [a, b, slack] of spans) {
      if (result[a] > result[b] + slack) result[a] = result[b] + slack, changed = true;
      if (result[b] > result[a] + slack) result[b] = result[a] + slack, changed = true;
    }
  }
  return result;
}

/** The metric at every vertex of a fine surface; `edges` are {ends, sides}. */
export function vertex_metrics(mesh, edges, region, sizing) {
  const wishes = wished_lengths(mesh, edges, region, sizing);
  const short = graded(wishes.map((w) => w.short), mesh.positions, edges, sizing.gradation);
  const stretched = wishes.map((w, v) => Math.min(w.long, sizing.stretch * short[v]));
  const long = graded(stretched, mesh.positions, edges, sizing.gradation);
  return wishes.map(
      ({along}, v) => metric_of({short: short[v], long: Math.max(short[v], long[v]), along}));
}
