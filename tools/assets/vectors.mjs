// Points and directions as arrays [x, y, z].

export const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const sub = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scale = (s, a) => [s * a[0], s * a[1], s * a[2]];
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const norm = (a) => Math.sqrt(dot(a, a));
export const distance = (a, b) => norm(sub(a, b));
export const middle = (a, b) => scale(0.5, add(a, b));
export const cross = (a, b) =>
    [a[1] * b[2] - a[2] * b[1],
     a[2] * b[0] - a[0] * b[2],
     a[0] * b[1] - a[1] * b[0],
];

/** The unit vector along a; zero stays zero. */
export function unit(a) {
  const length = norm(a);
  return length > 0 ? scale(1 / length, a) : a;
}

/**
 * Area times the unit normal of a triangle whose corners run counter-clockwise seen from outside.
 */
export const area_vector = (a, b, c) => scale(0.5, cross(sub(b, a), sub(c, a)));

/** The three angles of a triangle [rad], at a, b and c. */
export function angles(a, b, c) {
  const at = (p, q, r) => {
    const u = sub(q, p), v = sub(r, p);
    return Math.atan2(norm(cross(u, v)), dot(u, v));
  };
  return [at(a, b, c), at(b, c, a), at(c, a, b)];
}

/** The point of the segment a-b nearest to p. */
export function closest_on_segment(p, a, b) {
  const d = sub(b, a), length2 = dot(d, d);
  const t = length2 > 0 ? dot(sub(p, a), d) / length2 : 0;
  return add(a, scale(Math.min(1, Math.max(0, t)), d));
}

/**
 * The point of the triangle a, b, c nearest to p (Ericson, Real-Time Collision Detection, 5.1.5).
 */
export function closest_on_triangle(p, a, b, c) {
  const n = cross(sub(b, a), sub(c, a)), nn = dot(n, n);
  const inside = (u, v) => dot(cross(sub(v, u), sub(p, u)), n) >= 0;
  if (nn > 0 && inside(a, b) && inside(b, c) && inside(c, a)) {
    return sub(p, scale(dot(sub(p, a), n) / nn, n));
  }
  const candidates = [[a, b], [b, c], [c, a]].map(([u, v]) => closest_on_segment(p, u, v));
  return candidates.reduce((best, q) => (distance(p, q) < distance(p, best) ? q : best));
}
