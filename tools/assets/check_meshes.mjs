// Prints what each mesh of scenes/meshes is like, and ends with status 1 when one is not a sound
// solid. It leaves out the open meshes of make_harbour.mjs unless they are named.
//
// Usage: node check_meshes.mjs [FILE.obj...]
import fs from 'node:fs';
import path from 'node:path';
import {fileURLToPath} from 'node:url';

import {self_intersections} from './intersections.mjs';
import {read_obj} from './mesh_file.mjs';
import {add, angles, area_vector, dot, norm, scale} from './vectors.mjs';

const folder = fileURLToPath(new URL('../../scenes/meshes/', import.meta.url));

// A half hull, parts that a scene unites, and a ground.
const kOpen = ['landing_craft_half.obj', 'quay_steps.obj', 'truck.obj'];

// Ratio of |sum of area vectors| to area: round-off of a few ten thousand terms stays below this.
const kClosure = 1e-13;

/** Directed edges, keyed "from to", with how often each occurs. */
function directed_edges(faces) {
  const count = new Map();
  for (const face of faces) {
    for (let k = 0; k < 3; ++k) {
      const key = `${face[k]} ${face[(k + 1) % 3]}`;
      count.set(key, (count.get(key) ?? 0) + 1);
    }
  }
  return count;
}

/** Undirected edges, and those that do not have exactly one face each way. */
function edge_census(faces) {
  const directed = directed_edges(faces), names = new Set();
  let faulty = 0;
  for (const key of directed.keys()) {
    const [a, b] = key.split(' '), name = Number(a) < Number(b) ? key : `${b} ${a}`;
    if (names.has(name)) continue;
    names.add(name);
    if (directed.get(key) !== 1 || directed.get(`${b} ${a}`) !== 1) ++faulty;
  }
  return {edges: names.size, faulty};
}

/** Vertices whose faces form more than one fan: the surface touches itself there. */
function pinched_vertices({positions, faces}) {
  const next = positions.map(() => new Map());
  for (const face of faces)
    face.forEach((v, k) => next[v].set(face[(k + 1) % 3], face[(k + 2) % 3]));
  return next
      .filter((step) => {
        const start = step.keys().next().value;
        let length = 0, at = start;
        do at = step.get(at), ++length;
        while (at !== start && at !== undefined && length <= step.size);
        return length !== step.size;
      })
      .length;
}

/** Volume, area, closure and angles. */
function measures({positions, faces}) {
  let volume = 0, area = 0, sum = [0, 0, 0], moment = [0, 0, 0];
  const least = [], sizes = [];
  for (const face of faces) {
    const [a, b, c] = face.map((v) => positions[v]), n = area_vector(a, b, c);
    const part = dot(a, n) / 3;
    volume += part;
    moment = add(moment, scale(part / 4, add(a, add(b, c))));
    area += norm(n);
    sum = add(sum, n);
    least.push(Math.min(...angles(a, b, c)) * 180 / Math.PI);
    sizes.push(norm(n));
  }
  least.sort((p, q) => p - q);
  const centroid = scale(1 / volume, moment), closure = norm(sum) / area;
  return {volume, area, centroid, closure, least, smallest: Math.min(...sizes)};
}

function extent({positions}) {
  return [0, 1, 2].map((k) => {
    const values = positions.map((p) => p[k]);
    return values.reduce((m, x) => Math.max(m, x)) - values.reduce((m, x) => Math.min(m, x));
  });
}

function duplicates(faces) {
  return faces.length -
      new Set(faces.map((face) => face.slice().sort((a, b) => a - b).join(' '))).size;
}

function print_measures(mesh, m) {
  const list = (values, digits) => values.map((x) => x.toFixed(digits)).join(', ');
  const quantile = (part) => m.least[Math.floor(part * (m.least.length - 1))].toFixed(1);
  console.log(
      `  volume ${m.volume.toFixed(5)} m^3, area ${m.area.toFixed(5)} m^2, ` +
      `size (${list(extent(mesh), 4)}) m, centroid (${list(m.centroid, 5)}) m`);
  console.log(
      `  least angle ${quantile(0)} deg, 1 % below ${quantile(0.01)}, half below ` +
      `${quantile(0.5)}; smallest face ${m.smallest.toExponential(2)} m^2; ` +
      `|sum n dA| / area ${m.closure.toExponential(1)}`);
}

function check(file) {
  const mesh = read_obj(file), {edges, faulty} = edge_census(mesh.faces), m = measures(mesh);
  const euler = mesh.positions.length - edges + mesh.faces.length;
  const faults = {
    'edges without one face each way': faulty,
    'pinched vertices': pinched_vertices(mesh),
    'duplicate faces': duplicates(mesh.faces),
    'faces cutting others': self_intersections(mesh),
    'faces without area': m.least.filter((angle) => !(angle > 0)).length,
    'inward': m.volume > 0 ? 0 : 1,
    'open': m.closure < kClosure ? 0 : 1,
  };
  console.log(
      `${path.basename(file)}: ${mesh.faces.length} triangles, ` +
      `${fs.statSync(file).size} bytes, genus ${1 - euler / 2}, faulty edges ${faulty}`);
  print_measures(mesh, m);
  const found = Object.entries(faults).filter(([, count]) => count > 0);
  found.forEach(([fault, count]) => console.log(`  FAULT ${fault}: ${count}`));
  return found.length === 0;
}

const asked = process.argv.slice(2);
const all = () =>
    fs.readdirSync(folder).filter((f) => f.endsWith('.obj') && !kOpen.includes(f)).sort()
        .map((f) => folder + f);
const sound = (asked.length > 0 ? asked : all()).map(check);
process.exitCode = sound.every(Boolean) ? 0 : 1;
