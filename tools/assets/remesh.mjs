// Even triangles on a given surface: edges are split, collapsed and turned, and vertices moved
// along the surface, until edges are as long as wished (Botsch, Kobbelt: A remeshing approach to
// multiresolution modeling, 2004; lengths from curvature as in Dunyach et al.: Adaptive remeshing
// for real-time mesh deformation, 2013). Creases stay, and so does every corner where three regions
// meet.
import {EditableMesh} from './editable_mesh.mjs';
import {add, dot, middle, scale, sub, unit} from './vectors.mjs';

const kRounds = 16;

// Edges of the first round are this much shorter than wished and grow by a factor each round, so
// that the mesh settles on the surface while it is still fine.
const kFirstCoarseness = 0.3;
const kCoarser = 1.2;

// An edge is split above and collapsed below these multiples of its wished length; 4/3 and 4/5
// bring the halves of a split edge nearer to the wish than the whole was.
const kSplitAbove = 4 / 3;
const kCollapseBelow = 4 / 5;

// Least cosine between two neighbouring faces that may be turned into each other.
const kFlatEnough = 0.8;

// Part of the way a vertex goes to where it is pulled; the whole way overshoots.
const kRelaxation = 0.7;

// Least cosine of the turn of a crease at a vertex that may be removed.
const kCreaseTurn = 0.4;

// Below this multiple of its wished length an edge is so short that no bend is lost with it.
const kNegligible = 0.4;

/** Puts a vertex on its region or crease and renews its metric; false where faces would fold. */
function settle(mesh, surface, v, p) {
  const regions = mesh.regions_at(v);
  if (regions.length > 2) return false;
  const found =
      regions.length === 1 ? surface.on_region(p, regions[0]) : surface.on_crease(p, regions);
  if (!mesh.may_move(v, found.point)) return false;
  mesh.positions[v] = found.point;
  mesh.metrics[v] = found.metric;
  return true;
}

function split_long(mesh, surface, coarseness) {
  for (const [a, b] of mesh.edges()) {
    if (mesh.relative_length(a, b) <= kSplitAbove * coarseness) continue;
    const m = mesh.split(a, b);
    settle(mesh, surface, m, mesh.positions[m]);
  }
}

/** Which end of an edge may be drawn into the other, [gone, kept]; null where neither may. */
function collapse_order(mesh, a, b) {
  const [rank_a, rank_b] = [a, b].map((v) => mesh.regions_at(v).length);
  const [gone, kept] = rank_a <= rank_b ? [a, b] : [b, a];
  const rank = Math.min(rank_a, rank_b);
  if (rank > 2 || (rank === 2 && !mesh.is_crease(a, b))) return null;
  return [gone, kept];
}

/** Whether the edges that `gone` hands over to `kept` stay short enough not to be split again. */
function stays_short(mesh, gone, kept, coarseness) {
  const limit = Math.max(
      kSplitAbove * coarseness, ...mesh.neighbours(gone).map((v) => mesh.relative_length(gone, v)));
  return mesh.neighbours(gone).every((v) => v === kept || mesh.relative_length(kept, v) <= limit);
}

/**
 * Whether a vertex may leave its crease: not where the crease turns so much that a bend would be
 * cut off.
 */
function may_leave(mesh, gone, kept, coarseness) {
  if (mesh.regions_at(gone).length === 1) return true;
  if (mesh.relative_length(gone, kept) < kNegligible * coarseness) return true;
  const [before, after] = mesh.neighbours(gone)
                              .filter((v) => mesh.is_crease(gone, v))
                              .map((v) => unit(sub(mesh.positions[v], mesh.positions[gone])));
  return dot(before, after) < -kCreaseTurn;
}

function collapse_short(mesh, coarseness) {
  for (const [a, b] of mesh.edges()) {
    const sides = mesh.sides(a, b);
    if (sides.length !== 2 || mesh.relative_length(a, b) >= kCollapseBelow * coarseness) continue;
    const order = collapse_order(mesh, a, b);
    if (!order || !mesh.may_collapse(...order)) continue;
    const [gone, kept] = order;
    if (!stays_short(mesh, gone, kept, coarseness) || !may_leave(mesh, gone, kept, coarseness))
      continue;
    if (mesh.may_move(gone, mesh.positions[kept], sides)) mesh.collapse(gone, kept);
  }
}

const least_angle = (mesh, faces) =>
    Math.min(...faces.map((face) => mesh.relative_shape(face).least_angle));

/** Turns edges where that widens the least angle of the two faces. */
function turn_edges(mesh) {
  for (const [a, b] of mesh.edges()) {
    const sides = mesh.sides(a, b);
    if (sides.length !== 2) continue;
    const before = sides.map((f) => mesh.faces[f]), after = mesh.flipped(a, b);
    if (!after || least_angle(mesh, after) <= least_angle(mesh, before) + 1e-9) continue;
    const normals = [...before, ...after].map((face) => mesh.normal(face));
    if (normals.every((n) => dot(n, normals[0]) > kFlatEnough)) mesh.flip(a, b, after);
  }
}

/** Where a smooth vertex is pulled: the middle of its faces, weighted by area over wished area. */
function middle_of_faces(mesh, v) {
  let sum = [0, 0, 0], weights = 0;
  for (const f of mesh.around[v]) {
    const weight = mesh.relative_shape(mesh.faces[f]).area;
    sum = add(sum, scale(weight / 3, mesh.faces[f].map((w) => mesh.positions[w]).reduce(add)));
    weights += weight;
  }
  return scale(1 / weights, sum);
}

/** The step of a smooth vertex, along the surface. */
function smooth_step(mesh, v) {
  const normal = unit(mesh.around[v].map((f) => mesh.normal(mesh.faces[f])).reduce(add));
  const step = sub(middle_of_faces(mesh, v), mesh.positions[v]);
  return sub(step, scale(dot(step, normal), normal));
}

/** The step of a crease vertex to the middle of its two neighbours, along the crease. */
function crease_step(mesh, v) {
  const [p, q] =
      mesh.neighbours(v).filter((w) => mesh.is_crease(v, w)).map((w) => mesh.positions[w]);
  const tangent = unit(sub(q, p));
  return scale(dot(sub(middle(p, q), mesh.positions[v]), tangent), tangent);
}

function relax(mesh, surface) {
  for (let v = 0; v < mesh.positions.length; ++v) {
    if (mesh.around[v].length === 0) continue;
    const rank = mesh.regions_at(v).length;
    if (rank > 2) continue;
    const step = rank === 1 ? smooth_step(mesh, v) : crease_step(mesh, v);
    settle(mesh, surface, v, add(mesh.positions[v], scale(kRelaxation, step)));
  }
}

/**
 * Splits the edges that cut a corner off between two vertices of one crease, so that no face lies
 * in it.
 */
function split_chords(mesh, surface) {
  for (const [a, b] of mesh.edges()) {
    const regions = mesh.regions_at(b);
    const common = mesh.regions_at(a).filter((region) => regions.includes(region));
    if (common.length < 2 || mesh.is_crease(a, b)) continue;
    const m = mesh.split(a, b), [region] = mesh.regions_at(m);
    mesh.positions[m] = surface.on_region(mesh.positions[m], region).point;
  }
}

/** An even mesh of a ReferenceSurface, as an EditableMesh. */
export function remeshed(surface) {
  const mesh = new EditableMesh(surface.positions, surface.faces, surface.region, surface.metrics);
  for (let round = 0; round < kRounds; ++round) {
    const coarseness = Math.min(1, kFirstCoarseness * kCoarser ** round);
    split_long(mesh, surface, coarseness);
    for (let pass = 0; pass < 3; ++pass) collapse_short(mesh, coarseness);
    turn_edges(mesh);
    for (let pass = 0; pass < 3; ++pass) relax(mesh, surface);
    turn_edges(mesh);
  }
  split_chords(mesh, surface);
  return mesh;
}
