// One step of Loop's subdivision (1987) of a closed triangle mesh: each face becomes four, the surface smoother.

/** @param positions flat xyz   @param indices three per face   @returns the same two, finer */
export function subdivide({ positions, indices }) {
  const { vertices, faces } = welded(positions, indices);
  const edges = new Map();
  const edge = (a, b, opposite) => {
    const key = a < b ? `${a} ${b}` : `${b} ${a}`;
    if (!edges.has(key)) edges.set(key, { ends: [a, b], opposites: [], id: vertices.length + edges.size });
    edges.get(key).opposites.push(opposite);
    return edges.get(key).id;
  };
  const finer = faces.flatMap(([a, b, c]) => {
    const [ab, bc, ca] = [edge(a, b, c), edge(b, c, a), edge(c, a, b)];
    return [a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca];
  });
  const moved = movedVertices(vertices, edges.values());
  const middles = [...edges.values()].map(({ ends, opposites }) => edgePoint(vertices, ends, opposites));
  return { positions: Float32Array.from([...moved, ...middles].flat()), indices: Uint32Array.from(finer) };
}

function edgePoint(vertices, [a, b], opposites) {
  const at = (v) => vertices[v];
  if (opposites.length !== 2) return mix([at(a), at(b)], [1 / 2, 1 / 2]);
  return mix([at(a), at(b), at(opposites[0]), at(opposites[1])], [3 / 8, 3 / 8, 1 / 8, 1 / 8]);
}

function movedVertices(vertices, edges) {
  const neighbours = vertices.map(() => []);
  for (const { ends } of edges) {
    neighbours[ends[0]].push(ends[1]);
    neighbours[ends[1]].push(ends[0]);
  }
  return vertices.map((vertex, v) => {
    const ring = neighbours[v];
    const n = ring.length;
    const beta = (5 / 8 - (3 / 8 + Math.cos((2 * Math.PI) / n) / 4) ** 2) / n;
    return mix([vertex, ...ring.map((u) => vertices[u])], [1 - n * beta, ...ring.map(() => beta)]);
  });
}

/** Area-weighted normals per vertex, for a file that wants them. */
export function normalsOf({ positions, indices }) {
  const normals = new Float32Array(positions.length);
  const at = (v) => positions.subarray(3 * v, 3 * v + 3);
  for (let f = 0; f < indices.length; f += 3) {
    const [a, b, c] = [at(indices[f]), at(indices[f + 1]), at(indices[f + 2])];
    const [u, v] = [[0, 1, 2].map((i) => b[i] - a[i]), [0, 1, 2].map((i) => c[i] - a[i])];
    const n = [0, 1, 2].map((i) => u[(i + 1) % 3] * v[(i + 2) % 3] - u[(i + 2) % 3] * v[(i + 1) % 3]);
    for (let k = f; k < f + 3; k++) for (let i = 0; i < 3; i++) normals[3 * indices[k] + i] += n[i];
  }
  for (let v = 0; v < normals.length; v += 3) {
    const length = Math.hypot(...normals.subarray(v, v + 3)) || 1;
    for (let i = v; i < v + 3; i++) normals[i] /= length;
  }
  return normals;
}

function welded(positions, indices) {
  const ids = new Map();
  const vertices = [];
  const of = (v) => {
    const point = [...positions.subarray(3 * v, 3 * v + 3)];
    const key = point.join(' ');
    if (!ids.has(key)) ids.set(key, vertices.push(point) - 1);
    return ids.get(key);
  };
  const faces = [];
  for (let f = 0; f < indices.length; f += 3)
    faces.push([of(indices[f]), of(indices[f + 1]), of(indices[f + 2])]);
  return { vertices, faces };
}

function mix(points, weights) {
  return [0, 1, 2].map((axis) => points.reduce((sum, point, i) => sum + weights[i] * point[axis], 0));
}
