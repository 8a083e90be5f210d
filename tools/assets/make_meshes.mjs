// Makes every mesh of scenes/meshes. One part of each solid, a half or a quarter, is meshed evenly
// and mirrored, so that a symmetric body has an exactly symmetric mesh.
//
// Usage: node make_meshes.mjs [NAME...]
import fs from 'node:fs';
import {fileURLToPath} from 'node:url';

import {write_obj} from './mesh_file.mjs';
import {ReferenceSurface} from './reference_surface.mjs';
import {remeshed} from './remesh.mjs';
import {compartmented, extruded, half, revolved, rowing_boat, teapot, triangles, wigley} from './solids.mjs';

const folder = fileURLToPath(new URL('../../scenes/meshes/', import.meta.url));
const kDecimals = 6;  // micrometres

// Outline of the barge from the side (x, z): flat bottom, both ends raked.
const barge_side = [[-7, 0], [7, 0], [10, 1.8], [10, 3], [-10, 3], [-10, 1.8]];

// The same of the small barge with rooms below its deck.
const pontoon_side = [[-5, 0], [5, 0], [6, 0.9], [6, 1.5], [-6, 1.5], [-6, 0.9]];

// Profiles (radius, height), counter-clockwise, the axis on the left.
const spar_profile =
    [[0, 0], [1.1, 0], [1.1, 1.2], [0.5, 2], [0.5, 8], [0.12, 8.6], [0.12, 12], [0, 12]];
const bucket_profile = [[0, 0], [0.22, 0], [0.3, 0.6], [0.27, 0.6], [0.195, 0.04], [0, 0.04]];

/**
 * What is meshed, across which axes (0 for x, 1 for y) it is mirrored, and its sizing (sizing.mjs).
 * The teapots' errors are chosen for about 1,000, 5,000 and 20,000 triangles.
 */
const assets = {
  teapot_1k: {
    solid: teapot,
    mirror: [1],
    sizing: {error: 0.013, shortest: 0.09, longest: 0.38, stretch: 2, gradation: 0.8},
  },
  teapot: {
    solid: teapot,
    mirror: [1],
    sizing: {error: 0.0047, shortest: 0.025, longest: 0.2, stretch: 2.2, gradation: 0.6},
  },
  teapot_20k: {
    solid: teapot,
    mirror: [1],
    sizing: {error: 0.0012, shortest: 0.014, longest: 0.1, stretch: 1.7, gradation: 0.35},
  },
  wigley: {
    solid: () => wigley({length: 10, breadth: 1, draft: 0.625, freeboard: 0.375}),
    mirror: [0, 1],
    sizing: even(0.15),
  },
  barge: {solid: () => extruded(barge_side, 8), mirror: [0, 1], sizing: even(0.92)},
  spar: {
    solid: () => revolved(spar_profile),
    mirror: [0, 1],
    sizing: {error: 0.012, shortest: 0.12, longest: 0.36, stretch: 1.6, gradation: 0.35},
  },
  bucket: {solid: () => revolved(bucket_profile), mirror: [0, 1], sizing: even(0.057)},
  rowing_boat: {solid: rowing_boat, mirror: [1], sizing: even(0.185)},
  compartment_barge: {
    solid: () => compartmented(pontoon_side, 4, 0.15, [-3, 0, 3]),
    mirror: [0, 1],
    sizing: even(0.75),
  },
};

/** Edges of one length everywhere. */
function even(length) {
  return {error: length, shortest: length, longest: length, stretch: 1, gradation: 1};
}

/** A mesh and its mirror image across the plane where coordinate `axis` is zero, sewn together. */
function mirrored({positions, faces}, axis) {
  const image = positions.map((p, v) => (p[axis] === 0 ? v : -1));
  const all = positions.slice();
  positions.forEach((p, v) => {
    if (image[v] < 0) image[v] = all.push(p.map((x, k) => (k === axis ? -x : x))) - 1;
  });
  const turned = faces.map(([a, b, c]) => [image[a], image[c], image[b]]);
  return {positions: all, faces: [...faces, ...turned]};
}

/**
 * Numbers of the regions that lie in one of the planes of symmetry, as a map to the axis across
 * it.
 */
function cut_regions(surface, axes) {
  const cuts = new Map();
  for (const axis of axes) {
    const off_plane = new Set();
    surface.faces.forEach((face, f) => {
      if (face.some((v) => Math.abs(surface.positions[v][axis]) > kOnPlane))
        off_plane.add(surface.region[f]);
    });
    new Set(surface.region).forEach((r) => {
      if (!off_plane.has(r)) cuts.set(r, axis);
    });
  }
  return cuts;
}

// Cut faces leave Manifold within single precision of the plane [m].
const kOnPlane = 1e-6;

/** Vertices at the edge of a cut face go onto the plane exactly, so that both halves share them. */
function flatten_cuts(mesh, cuts) {
  mesh.positions.forEach((p, v) => {
    const flat = mesh.regions_at(v).filter((r) => cuts.has(r)).map((r) => cuts.get(r));
    mesh.positions[v] = p.map((x, k) => (flat.includes(k) ? 0 : x));
  });
}

function make(name) {
  const {solid, mirror, sizing} = assets[name];
  const {whole, ridges} = solid();
  const fine = triangles(mirror.reduce(half, whole), sizing.longest);
  const surface = new ReferenceSurface(fine, ridges, {...sizing, finest: sizing.shortest / 50});
  const mesh = remeshed(surface);
  const cuts = cut_regions(surface, mirror);
  flatten_cuts(mesh, cuts);
  const open = mesh.compact((region) => !cuts.has(region));
  const sewn = mirror.reduce(mirrored, open);
  write_obj(`${folder}${name}.obj`, sewn, {title: `Plimsoll mesh ${name}`, decimals: kDecimals});
  console.log(`${name}: ${sewn.faces.length} triangles; the fine solid has ${
      whole.volume().toFixed(5)} m^3`);
}

fs.mkdirSync(folder, {recursive: true});
const asked = process.argv.slice(2);
const unknown = asked.filter((name) => !(name in assets));
if (unknown.length > 0) {
  throw new Error(`unknown: ${unknown.join(', ')}; known: ${Object.keys(assets).join(', ')}`);
}
(asked.length > 0 ? asked : Object.keys(assets)).forEach(make);
