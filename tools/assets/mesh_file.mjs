// Wavefront OBJ, as far as the project's meshes need it: vertices and triangles.
import fs from 'node:fs';

/** Writes a mesh {positions, faces} with the given number of decimals. */
export function write_obj(path, mesh, {title, decimals}) {
  const number = (x) => String(Number(x.toFixed(decimals)) + 0);
  const vertices = mesh.positions.map((p) => `v ${p.map(number).join(' ')}\n`);
  const faces = mesh.faces.map((f) => `f ${f.map((v) => v + 1).join(' ')}\n`);
  fs.writeFileSync(path, `# ${title}\n# m, z up\n${vertices.join('')}${faces.join('')}`);
}

/** Reads the vertices and triangles of an OBJ file. */
export function read_obj(path) {
  const positions = [], faces = [];
  for (const line of fs.readFileSync(path, 'utf8').split('\n')) {
    const [kind, ...words] = line.trim().split(/\s+/);
    if (kind === 'v') positions.push(words.map(Number));
    if (kind === 'f') faces.push(words.map((word) => parseInt(word, 10) - 1));
  }
  return {positions, faces};
}
