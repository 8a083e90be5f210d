// Pairs of triangles of a mesh that cut through each other.
import {area_vector, cross, dot, norm, sub} from './vectors.mjs';

/** Whether segment p-q passes through the inside of triangle a, b, c; touching does not count. */
function pierces(p, q, [a, b, c]) {
  const d = sub(q, p), ab = sub(b, a), ac = sub(c, a), h = cross(d, ac);
  const determinant = dot(ab, h);
  if (Math.abs(determinant) < 1e-12 * norm(d) * norm(ab) * norm(ac)) return false;
  const s = sub(p, a), k = cross(s, ab);
  const u = dot(s, h) / determinant, v = dot(d, k) / determinant, t = dot(ac, k) / determinant;
  const inside = 1e-9;
  return u > inside && v > inside && u + v < 1 - inside && t > inside && t < 1 - inside;
}

/** Whether two faces with two common vertices lie folded onto each other. */
function folded(mesh, face, other) {
  const normal = (f) => area_vector(...f.map((v) => mesh.positions[v]));
  const m = normal(face), n = normal(other);
  return dot(m, n) < -(1 - 1e-9) * norm(m) * norm(n);
}

function cut(mesh, face, other) {
  const common = face.filter((v) => other.includes(v)).length;
  if (common === 3) return true;
  if (common === 2) return folded(mesh, face, other);
  const corners = (f) => f.map((v) => mesh.positions[v]);
  const edges = (f) => [0, 1, 2].map((k) => [f[k], f[(k + 1) % 3]].map((v) => mesh.positions[v]));
  return edges(face).some(([p, q]) => pierces(p, q, corners(other))) ||
      edges(other).some(([p, q]) => pierces(p, q, corners(face)));
}

/** Lower and upper corner of a face's box. */
function box({positions}, face) {
  const along = (k, pick) => pick(...face.map((v) => positions[v][k]));
  return [[0, 1, 2].map((k) => along(k, Math.min)), [0, 1, 2].map((k) => along(k, Math.max))];
}

const overlap = ([low, high], [other_low, other_high]) => [0, 1, 2].every(
    (k) => low[k] <= other_high[k] && other_low[k] <= high[k]);

/** Number of pairs of faces that cut each other, found by a sweep along x. */
export function self_intersections(mesh) {
  const items = mesh.faces.map((face) => ({face, box: box(mesh, face)}));
  items.sort((a, b) => a.box[0][0] - b.box[0][0]);
  let count = 0, active = [];
  for (const item of items) {
    active = active.filter((other) => other.box[1][0] >= item.box[0][0]);
    for (const other of active) {
      if (overlap(item.box, other.box) && cut(mesh, item.face, other.face)) ++count;
    }
    active.push(item);
  }
  return count;
}
