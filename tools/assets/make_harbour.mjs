// Writes small files of the scenes landing_craft, bouncing_balls and basin_model, without packages:
//
//   meshes/landing_craft_half.obj   the port side of an open shell without thickness, in three
//                                   patches with cracks of 3 mm between them
//   meshes/truck.obj                closed parts that overlap, and a load box without a bottom
//   meshes/quay_steps.obj           steps of a quay that lead down into the water, faces upward
//   files/beach.png                 heights of a beach, 16 bits of grey
//   files/basin_gauge.csv           a record of a wave gauge: a sum of waves, and noise
import fs from 'node:fs';
import zlib from 'node:zlib';

const scenes = new URL('../../scenes/', import.meta.url);
const write = (name, data) => {
  fs.writeFileSync(new URL(name, scenes), data);
  console.log(`${name}: ${data.length} bytes`);
};

/** A mesh of triangles. */
class Mesh {
  vertices = [];
  faces = [];

  /** Adds a convex face, as a fan. @param corners   Counter-clockwise as seen from outside. */
  add(...corners) {
    const face = corners.map((corner) => {
      const text = corner.map((c) => +c.toFixed(4)).join(' ');
      const known = this.vertices.indexOf(text);
      return known >= 0 ? known + 1 : this.vertices.push(text);
    });
    for (let i = 1; i + 1 < face.length; ++i) this.faces.push([face[0], face[i], face[i + 1]]);
  }

  /** Adds a patch. @param at   Point of the patch at u and v from 0 to 1. */
  patch(nu, nv, at) {
    for (let i = 0; i < nu; ++i)
      for (let k = 0; k < nv; ++k)
        this.add(at(i / nu, k / nv), at((i + 1) / nu, k / nv), at((i + 1) / nu, (k + 1) / nv),
                 at(i / nu, (k + 1) / nv));
  }

  /** Adds a box between two corners. @param open   Whether its bottom is missing. */
  box([x, y, z], [X, Y, Z], open = false) {
    this.add([x, y, Z], [X, y, Z], [X, Y, Z], [x, Y, Z]);
    this.add([x, y, z], [X, y, z], [X, y, Z], [x, y, Z]);
    this.add([X, Y, z], [x, Y, z], [x, Y, Z], [X, Y, Z]);
    this.add([X, y, z], [X, Y, z], [X, Y, Z], [X, y, Z]);
    this.add([x, Y, z], [x, y, z], [x, y, Z], [x, Y, Z]);
    if (!open) this.add([x, Y, z], [X, Y, z], [X, y, z], [x, y, z]);
  }

  /** Adds a wheel about an axis along y. */
  wheel([x, y, z], radius, width) {
    const kCorners = 12;
    const rim = (side) => Array.from({length: kCorners}, (_, i) => {
      const angle = 2 * Math.PI * i / kCorners;
      return [x + radius * Math.cos(angle), y + side * width / 2, z + radius * Math.sin(angle)];
    });
    const [right, left] = [rim(-1), rim(1)];
    for (let i = 0; i < kCorners; ++i) {
      const n = (i + 1) % kCorners;
      this.add(right[i], left[i], left[n], right[n]);
    }
    this.add(...right);
    this.add(...left.reverse());
  }

  text(head) {
    return `# ${head}\n${this.vertices.map((v) => `v ${v}`).join('\n')}\n` +
           `${this.faces.map((f) => `f ${f.join(' ')}`).join('\n')}\n`;
  }
}

function landing_craft_half() {
  const mesh = new Mesh();
  const kLength = 10, kHalfBeam = 1.8, kDepth = 1.3, kCrack = 0.003;
  const keel = (x) => 0.9 * Math.max(0, (x - 2) / 3) ** 1.5;  // The bottom rises towards the bow.
  const station = (u) => kLength * (u - 0.5);
  mesh.patch(12, 3, (u, v) => [station(u), kHalfBeam * (1 - v), keel(station(u))]);
  mesh.patch(12, 2, (u, v) => [station(1 - u), kHalfBeam + kCrack,
                               keel(station(1 - u)) + v * (kDepth - keel(station(1 - u)))]);
  mesh.patch(3, 2, (u, v) => [-kLength / 2 - kCrack, kHalfBeam * (1 - u), kDepth * v]);
  return mesh.text('Port side of an open landing craft, in m: bottom, side and transom');
}

function truck() {
  const mesh = new Mesh();
  mesh.box([-2, -0.75, 0.45], [2, 0.75, 0.75]);         // chassis
  mesh.box([0.9, -0.8, 0.6], [1.9, 0.8, 1.9]);          // cab
  mesh.box([-2, -0.85, 0.8], [0.7, 0.85, 1.8], true);   // load
  mesh.box([-1.8, -0.6, 0.7], [0.5, 0.6, 0.9]);         // frame that carries it
  for (const x of [-1.3, 1.3])
    for (const y of [-0.75, 0.75]) mesh.wheel([x, y, 0.4], 0.4, 0.25);
  return mesh.text('Truck of parts that overlap, in m; the load has no bottom');
}

function quay_steps() {
  const mesh = new Mesh();
  const kWidth = 4, kTread = 1.2, kRise = 0.6, kSteps = 4;
  const across = (x, z, X, Z) =>
      mesh.add([x, -kWidth, z], [X, -kWidth, Z], [X, kWidth, Z], [x, kWidth, z]);
  across(-5, 1.8, 0, 1.8);
  for (let i = 0; i < kSteps; ++i) {
    const [x, z] = [i * kTread, 1.8 - i * kRise];
    across(x, z, x, z - kRise);
    across(x, z - kRise, x + kTread, z - kRise);
  }
  across(kSteps * kTread, 1.8 - kSteps * kRise, kSteps * kTread, -4);
  across(kSteps * kTread, -4, 14, -4);
  return mesh.text('Steps of a quay, in m, faces upward');
}

/** Wraps the parts of a PNG file. */
function chunk(type, data) {
  const body = Buffer.concat([Buffer.from(type, 'latin1'), data]);
  let crc = ~0;
  for (const byte of body) {
    crc ^= byte;
    for (let i = 0; i < 8; ++i) crc = crc >>> 1 ^ (crc & 1 ? 0xedb88320 : 0);
  }
  const bytes = Buffer.alloc(body.length + 8);
  bytes.writeUInt32BE(data.length, 0);
  body.copy(bytes, 4);
  bytes.writeUInt32BE(~crc >>> 0, body.length + 4);
  return bytes;
}

/** @param height   Grey at a column and a row, from 0 to 1. Row 0 is the first, at the least y. */
function png(width, rows, height) {
  const raw = Buffer.alloc(rows * (1 + 2 * width));
  for (let r = 0; r < rows; ++r)
    for (let c = 0; c < width; ++c)
      raw.writeUInt16BE(Math.round(65535 * height(c, r)), r * (1 + 2 * width) + 1 + 2 * c);
  const head = Buffer.alloc(13);
  head.writeUInt32BE(width, 0);
  head.writeUInt32BE(rows, 4);
  head.set([16, 0, 0, 0, 0], 8);  // 16 bits of grey
  return Buffer.concat([Buffer.from('\x89PNG\r\n\x1a\n', 'latin1'), chunk('IHDR', head),
                        chunk('IDAT', zlib.deflateSync(raw, {level: 9})),
                        chunk('IEND', Buffer.alloc(0))]);
}

/** A beach that rises with x, with a hollow along its middle and low dunes at its top. */
function beach(column, row) {
  const x = column / 47, y = (row - 15.5) / 15.5;
  const dunes = Math.max(0, x - 0.75) * 0.5 * (Math.cos(9 * y) + 0.5 * Math.cos(23 * y + 1));
  return Math.min(1, Math.max(0, 0.05 + 0.75 * x ** 1.2 + 0.04 * y ** 2 + dunes));
}

function basin_gauge() {
  let seed = 1;
  const random = () => (seed = seed * 48271 % 2147483647) / 2147483647;  // Park and Miller
  const waves = Array.from({length: 24}, (_, i) => {
    const f = 0.45 + 0.03 * i, r = f / 0.65;  // A spectrum of the peak 0.65 Hz
    return [0.0165 * r ** -2.5 * Math.exp(-0.625 * r ** -4 + 0.625), f, 2 * Math.PI * random()];
  });
  const lines = [];
  for (let i = 0; i < 800; ++i) {
    const t = i * 0.05;
    const z = waves.reduce((sum, [a, f, phase]) =>
        sum + a * Math.cos(2 * Math.PI * f * t + phase), 0);
    lines.push(`${t.toFixed(2)},${(z + 0.001 * (random() - 0.5) + 0.002).toFixed(4)}`);
  }
  return '# A made record of a wave gauge, 24 waves with a peak at 1.5 s and noise\n' +
         `time,elevation\n${lines.join('\n')}\n`;
}

write('meshes/landing_craft_half.obj', landing_craft_half());
write('meshes/truck.obj', truck());
write('meshes/quay_steps.obj', quay_steps());
write('files/beach.png', png(48, 32, beach));
write('files/basin_gauge.csv', basin_gauge());
