// The fine surfaces of the solids, before they are meshed evenly. Each is a closed Manifold solid,
// outward, z up, with its ridges: lines of its vertices where it is smooth but bends tightly.
import load_manifold from 'manifold-3d';
import fs from 'node:fs';
import {fileURLToPath} from 'node:url';

import {add, scale, sub, unit} from './vectors.mjs';

const module = await load_manifold();
module.setup();
const {CrossSection, Manifold, Mesh} = module;

const newell = JSON.parse(
    fs.readFileSync(fileURLToPath(new URL('newell_teapot.json', import.meta.url)), 'utf8'));

// How finely the reference surfaces are cut: steps a Bezier curve, steps a full turn. The chords
// are then off the true surface by less than 1e-4 of the radius.
const kCurveSteps = 32;
const kTurnSteps = 256;

/** Point of the cubic Bezier curve with control points c, at parameter t. */
function bezier(c, t) {
  const s = 1 - t, weights = [s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t];
  return c[0].map((_, k) => weights.reduce((sum, w, i) => sum + w * c[i][k], 0));
}

/** Points of a chain of Bezier curves, the joints once. */
function polyline(curves, steps) {
  const points = [curves[0][0]];
  for (const curve of curves) {
    for (let i = 1; i <= steps; ++i) points.push(bezier(curve, i / steps));
  }
  return points;
}

function solid(positions, faces) {
  const mesh = new Mesh({
    numProp: 3,
    vertProperties: Float32Array.from(positions.flat()),
    triVerts: Uint32Array.from(faces.flat()),
  });
  const made = new Manifold(mesh);
  if (!(made.volume() > 0)) throw new Error('a surface is open or turned inward');
  return made;
}

/**
 * The solid between consecutive rings of equally many points, with a point before the first ring
 * and one after the last. Rings run counter-clockwise seen from the last one.
 */
function lofted(first, rings, last) {
  const count = rings[0].length, end = 1 + rings.length * count;
  const at = (i, j) => 1 + i * count + (j % count);
  const faces = [];
  for (let j = 0; j < count; ++j) {
    faces.push([0, at(0, j + 1), at(0, j)]);
    faces.push([end, at(rings.length - 1, j), at(rings.length - 1, j + 1)]);
  }
  for (let i = 0; i + 1 < rings.length; ++i) {
    for (let j = 0; j < count; ++j) {
      faces.push([at(i, j), at(i, j + 1), at(i + 1, j + 1)]);
      faces.push([at(i, j), at(i + 1, j + 1), at(i + 1, j)]);
    }
  }
  return solid([first, ...rings.flat(), last], faces);
}

/** Newell's circle: four Bezier quarters, up to 0.4 % outside the unit circle. */
function newell_circle() {
  const q = newell.quarter_circle;
  const quarter = [[1, 0], [1, q], [q, 1], [0, 1]];
  const turns =
      [([x, y]) => [x, y], ([x, y]) => [-y, x], ([x, y]) => [-x, -y], ([x, y]) => [y, -x]];
  const circle = polyline(turns.map((turn) => quarter.map(turn)), kTurnSteps / 4);
  return circle.slice(0, -1);
}

/** The horizontal ring that a profile point (radius, height) sweeps. */
const newell_ring = ([r, z]) => newell_circle().map(([x, y]) => [r * x, r * y, z]);

/**
 * Pot, lid and bottom in one: the profile's curves swept, the gap between lid and rim closed flat.
 */
function pot() {
  const {lid, rim, body, bottom} = newell.profile;
  const profile =
      [...polyline(lid, kCurveSteps), ...polyline([...rim, ...body, ...bottom], kCurveSteps)];
  const [lowest, ...between] = profile.reverse();
  const highest = between.pop();
  return lofted([0, 0, lowest[1]], between.map(newell_ring), [0, 0, highest[1]]);
}

/** Where the teapot bends most tightly, with radii from 0.003 to 0.07 of Newell's units. */
function teapot_ridges() {
  const {lid, rim, bottom} = newell.profile;
  const around_pot = [[lid[0], 10], [lid[0], 29], [rim[0], 13], [bottom[0], 4]].map(
      ([curve, step]) => newell_ring(bezier(curve, step / kCurveSteps)));
  const lip = tube_ring(newell.tubes.spout[1], 0.5, lip_bend);
  return [...around_pot, lip];
}

// Along the spout's lip patch the tightest bend is not at one parameter: Bezier values of the
// parameter where it lies, from the pot's side of the mouth round to the tip.
const kLipBend = [[0.66], [0.62], [0.4], [0.425]];

/**
 * The parameter along a patch, of the step `s` out of 1, when the step 0.5 shall fall on `middle`.
 */
const leaned = (s, middle) => (s < 0.5 ? 2 * s * middle : middle + (2 * s - 1) * (1 - middle));

/**
 * A closed ring around a tube patch at the step `s`; `middle(w)` is the parameter of the step 0.5.
 */
function tube_ring(patch, s, middle) {
  const steps = kTurnSteps / 8;
  const half = Array.from({length: steps + 1}, (_, i) => {
    const along = patch.map((section) => bezier(section, i / steps));
    return bezier(along, leaned(s, middle(i / steps)));
  });
  const mirrored = half.slice(1, -1).reverse().map(([x, y, z]) => [x, -y, z]);
  return [...half, ...mirrored];
}

const straight = () => 0.5;
const lip_bend = (w) => bezier(kLipBend, w)[0];

/** The rings of a tube of two patches, those of the second spread around `middle`. */
function tube_rings([first, second], middle) {
  const steps = Array.from({length: kCurveSteps + 1}, (_, i) => i / kCurveSteps);
  return [
    ...steps.slice(0, -1).map((s) => tube_ring(first, s, straight)),
    ...steps.map((s) => tube_ring(second, s, middle))
  ];
}

const centre = (ring) => scale(1 / ring.length, ring.reduce(add));

/** A ring moved by `reach` away from its neighbour: the tube carried on straight. */
function carried_on(ring, neighbour, reach) {
  const shift = scale(reach, unit(sub(centre(ring), centre(neighbour))));
  return ring.map((p) => add(p, shift));
}

/**
 * A closed tube; its ends are carried on by `before` and `after` into the pot, where they vanish.
 */
function tube(patches, {before, after, middle = straight}) {
  const rings = tube_rings(patches, middle);
  if (before > 0) rings.unshift(carried_on(rings[0], rings[1], before));
  if (after > 0) rings.push(carried_on(rings.at(-1), rings.at(-2), after));
  return lofted(centre(rings[0]), rings, centre(rings.at(-1)));
}

/**
 * The teapot, in metres: the pot's greatest radius is 1 m, z = 0 at its bottom, the spout towards
 * +x.
 */
export function teapot() {
  const handle = tube(newell.tubes.handle, {before: 0.5, after: 0.4});
  const spout = tube(newell.tubes.spout, {before: 0.5, after: 0, middle: lip_bend});
  const halved = (p) => scale(0.5, p.map(Math.fround));
  return {
    whole: Manifold.union([pot(), handle, spout]).scale(0.5),
    ridges: teapot_ridges().map((ridge) => ridge.map(halved)),
  };
}

/** The two triangles of a quadrilateral, less those that have shrunk to a line. */
function quad(a, b, c, d) {
  return [[a, b, c], [a, c, d]].filter(([p, q, r]) => p !== q && q !== r && r !== p);
}

/**
 * Wigley's hull: y = B/2 (1 - (2x/L)^2) (1 - (z/T)^2) below z = 0, upright sides from there to a
 * flat deck. The two sides share the vertices of keel and stems, where the breadth is zero.
 */
export function wigley({length, breadth, draft, freeboard}) {
  const stations = 96, rows = 48;
  const positions = [], index = new Map();
  const vertex = (i, j, side) => {
    const x = length * (i / stations - 0.5);
    const z = (j <= rows / 2 ? draft : freeboard) * (2 * j / rows - 1);
    const y = 0.5 * breadth * (1 - (2 * x / length) ** 2) * (1 - (Math.min(z, 0) / draft) ** 2);
    const key = `${i} ${j} ${y === 0 ? 0 : side}`;
    if (!index.has(key)) index.set(key, positions.push([x, side * y, z]) - 1);
    return index.get(key);
  };
  const faces = [];
  for (let i = 0; i < stations; ++i) {
    for (let j = 0; j < rows; ++j) {
      const corners = (side) => [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]].map(
          ([s, r]) => vertex(s, r, side));
      faces.push(...quad(...corners(-1)), ...quad(...corners(1).reverse()));
    }
    faces.push(...quad(
        vertex(i, rows, -1), vertex(i + 1, rows, -1), vertex(i + 1, rows, 1), vertex(i, rows, 1)));
  }
  return {whole: solid(positions, faces), ridges: []};
}

/**
 * The solid swept by a profile of points (radius, height), given counter-clockwise, about the z
 * axis.
 */
export function revolved(profile) {
  return {whole: Manifold.revolve([profile], kTurnSteps), ridges: []};
}

/**
 * The solid under a cross-section of points (x, z), given counter-clockwise, of a breadth across
 * y.
 */
export function extruded(section, breadth) {
  const whole = Manifold.extrude([section], breadth, 0, 0, [1, 1], true).rotate([90, 0, 0]);
  return {whole, ridges: []};
}

/**
 * The solid of `extruded` with closed rooms side by side along x. Walls are `wall` thick; the
 * bulkheads between the rooms have their middles at the given x.
 */
export function compartmented(section, breadth, wall, bulkheads) {
  const hull = extruded(section, breadth).whole;
  const inner = new CrossSection([section]).offset(-wall, 'Miter').toPolygons()[0];
  const hollow = extruded(inner, breadth - 2 * wall).whole;
  const walls = bulkheads.map(
      (x) => Manifold.cube([wall, 2 * breadth, 1000], true).translate([x, 0, 0]));
  return {whole: hull.subtract(hollow.subtract(Manifold.union(walls))), ridges: []};
}

// A rowing boat's breadth along its length, as a part of the greatest one: `u` is 0 at the transom
// and 1 at the stem.
const kTransom = 0.72, kWidest = 0.45;
const fullness = (u) => (u < kWidest ? 1 - (1 - kTransom) * (1 - u / kWidest) ** 2 :
                                       1 - ((u - kWidest) / (1 - kWidest)) ** 2);

/**
 * The solid between a flat bottom and the sheer, with flared sides. `bottom` and `sheer` have the x
 * of their ends, the greatest half breadth, the least height and the height of the stem above it;
 * `rise` carries the sides on above the sheer, as a part of their height.
 */
function flared({bottom, sheer, rise}) {
  const stations = 64, lowest = 0.4;
  const at = ({ends: [aft, fore], half_breadth, height, spring}, u, side) =>
      [aft + (fore - aft) * u, side * half_breadth * fullness(u),
       height + spring * ((u - lowest) / (1 - lowest)) ** 2];
  const positions = [], index = new Map();
  const vertex = (i, row, side) => {
    const u = i / stations, key = `${i} ${row} ${i === stations ? 0 : side}`;
    if (index.has(key)) return index.get(key);
    const low = at(bottom, u, side), high = at(sheer, u, side);
    const point = row === 0 ? low : add(low, scale(1 + rise, sub(high, low)));
    index.set(key, positions.push(point) - 1);
    return index.get(key);
  };
  const faces = quad(vertex(0, 0, 1), vertex(0, 0, -1), vertex(0, 1, -1), vertex(0, 1, 1)).map(
      ([a, b, c]) => [a, c, b]);
  const ring = [[0, 1], [0, -1], [1, -1], [1, 1]];
  for (let i = 0; i < stations; ++i) {
    ring.forEach(([row, side], k) => {
      const [next_row, next_side] = ring[(k + 1) % 4];
      faces.push(...quad(
          vertex(i, row, side), vertex(i, next_row, next_side), vertex(i + 1, next_row, next_side),
          vertex(i + 1, row, side)));
    });
  }
  return solid(positions, faces.map(([a, b, c]) => [a, c, b]));
}

/** An open rowing boat of 4 m with a thwart; the bottom is at z = 0 amidships. */
export function rowing_boat() {
  const wall = 0.04;
  const hull = flared({
    bottom: {ends: [-1.85, 1.7], half_breadth: 0.46, height: 0, spring: 0.1},
    sheer: {ends: [-2, 2], half_breadth: 0.74, height: 0.5, spring: 0.2},
    rise: 0,
  });
  const hollow = flared({
    bottom: {ends: [-1.81, 1.55], half_breadth: 0.42, height: wall, spring: 0.1},
    sheer: {ends: [-1.96, 1.86], half_breadth: 0.7, height: 0.5, spring: 0.2},
    rise: 0.5,
  });
  const thwart = Manifold.cube([0.26, 2, wall], true).translate([-0.2, 0, 0.28]);
  const whole = Manifold.union([hull.subtract(hollow), Manifold.intersection([thwart, hull])]);
  return {whole, ridges: []};
}

/** The part of a solid with coordinate `axis` (0 for x, 1 for y) above zero. */
export function half(whole, axis) {
  return whole.trimByPlane([axis === 0 ? 1 : 0, axis === 1 ? 1 : 0, 0], 0);
}

/** A solid's triangles, none with an edge longer than `length`. */
export function triangles(whole, length) {
  const mesh = whole.refineToLength(length).getMesh();
  const positions = [], faces = [];
  for (let i = 0; i < mesh.vertProperties.length; i += mesh.numProp) {
    positions.push(Array.from(mesh.vertProperties.slice(i, i + 3)));
  }
  for (let i = 0; i < mesh.triVerts.length; i += 3)
    faces.push(Array.from(mesh.triVerts.slice(i, i + 3)));
  return merged({positions, faces}, mesh);
}

/** Vertices that Manifold keeps apart for their origin become one. */
function merged({positions, faces}, mesh) {
  const target = positions.map((_, v) => v);
  mesh.mergeFromVert.forEach((from, i) => {
    target[from] = mesh.mergeToVert[i];
  });
  return {positions, faces: faces.map((face) => face.map((v) => target[v]))};
}
