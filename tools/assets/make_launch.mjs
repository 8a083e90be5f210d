// Writes scenes/meshes/launch_mm_y_up.stl, a motor launch as a modelling program would export it:
// binary STL, millimetres, y up, bow along x, z to starboard. It needs no packages.
import fs from 'node:fs';

const kLength = 5200, kHalfBeam = 950, kStations = 26, kPerPanel = 3;

/** Keel, chine, sheer and middle of the deck at x from 0 (transom) to 1: [height, half breadth]. */
function section(x) {
  const full = 1 - Math.max(0, (x - 0.4) / 0.6) ** 2.4;
  const rise = Math.max(0, (x - 0.55) / 0.45);
  const sheer = 780 + 220 * x ** 2;
  return [[520 * rise ** 2.6, 0], [170 + 480 * rise ** 2.2, 0.86 * kHalfBeam * full],
          [sheer, kHalfBeam * full], [sheer + 40 * full, 0]];
}

/** Points from the keel to the sheer of one side of a station, and on to the middle of the deck. */
function outline(x) {
  const corners = section(x);
  const points = [corners[0]];
  for (let c = 1; c < corners.length; ++c)
    for (let k = 1; k <= kPerPanel; ++k)
      points.push(corners[c].map((to, i) => {
        const from = corners[c - 1][i];
        return from + (to - from) * k / kPerPanel;
      }));
  return points.map(([height, breadth]) => [kLength * (x - 0.5), height, breadth]);
}

const triangles = [];

/**
 * Adds a triangle of the starboard side and its mirror image, unless it has no area or lies in the
 * plane of symmetry, where both would be one.
 */
function add(a, b, c) {
  if ([a, b, c].every((p) => p[2] === 0)) return;
  const u = b.map((q, i) => q - a[i]), v = c.map((q, i) => q - a[i]);
  const area = Math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                          u[0] * v[1] - u[1] * v[0]);
  if (area < 1) return;
  triangles.push([a, b, c]);
  const mirrored = (p) => [p[0], p[1], p[2] === 0 ? 0 : -p[2]];
  triangles.push([mirrored(a), mirrored(c), mirrored(b)]);
}

const stations = Array.from({length: kStations}, (_, i) => outline(i / (kStations - 1)));
for (let s = 0; s + 1 < kStations; ++s)
  for (let k = 0; k + 1 < stations[s].length; ++k) {
    const [aft, fore] = [stations[s], stations[s + 1]];
    add(aft[k], fore[k], fore[k + 1]);
    add(aft[k], fore[k + 1], aft[k + 1]);
  }
// The transom is a fan about the middle of its keel and deck lines.
const transom = stations[0];
const middle = [transom[0][0], 400, 0];
for (let k = 0; k + 1 < transom.length; ++k) add(middle, transom[k], transom[k + 1]);
add(middle, transom.at(-1), transom[0]);

const bytes = Buffer.alloc(84 + 50 * triangles.length);
bytes.write('Plimsoll mesh launch, mm, y up', 0, 'latin1');
bytes.writeUInt32LE(triangles.length, 80);
triangles.forEach((triangle, t) => triangle.flat().forEach((coordinate, i) => {
  bytes.writeFloatLE(coordinate, 84 + 50 * t + 12 + 4 * i);
}));
const file = new URL('../../scenes/meshes/launch_mm_y_up.stl', import.meta.url);
fs.writeFileSync(file, bytes);
console.log(`launch_mm_y_up: ${triangles.length} triangles`);
