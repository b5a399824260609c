// Meshes of our own: each is a grid of quads wrapped around, written as text.

const tau = 2 * Math.PI;

/** A fluted, twisted vase without a lid: quads, one boundary loop at the rim, closed at the foot; texture coordinates. OBJ. */
export function openVase({ around = 144, along = 96 } = {}) {
  const lines = ['# Twisted vase, made for Whittle. CC0 1.0', 'o vase'];
  for (let row = 0; row <= along; row++) {
    const t = row / along;
    for (let column = 0; column < around; column++) {
      const angle = tau * (column / around);
      const profile = 0.42 + 0.24 * Math.sin(Math.PI * (0.08 + 1.25 * t)) + 0.16 * t ** 6;
      const flute = 1 + 0.075 * Math.cos(7 * angle + 3.2 * t) * (1 - 0.75 * t ** 5);
      const r = profile * flute;
      lines.push(`v ${fixed(r * Math.cos(angle))} ${fixed(1.9 * t - 0.95)} ${fixed(r * Math.sin(angle))}`);
    }
  }
  lines.push('v 0 -0.95 0');
  // Twice around, once up: about square. The seam and the foot have coordinates of their own.
  for (let row = 0; row <= along; row++)
    for (let column = 0; column <= around; column++)
      lines.push(`vt ${fixed((2 * column) / around)} ${fixed(row / along)}`);
  lines.push('vt 0.5 -0.1');
  const at = (row, column) => `${1 + row * around + (column % around)}/${1 + row * (around + 1) + column}`;
  for (let row = 0; row < along; row++)
    for (let column = 0; column < around; column++)
      lines.push(
        `f ${at(row, column)} ${at(row + 1, column)} ${at(row + 1, column + 1)} ${at(row, column + 1)}`,
      );
  const foot = `${(along + 1) * around + 1}/${(along + 1) * (around + 1) + 1}`;
  for (let column = 0; column < around; column++)
    lines.push(`f ${foot} ${at(0, column)} ${at(0, column + 1)}`);
  return `${lines.join('\n')}\n`;
}

/**
 * A smooth, round jar, fine enough to show a relief: open at the rim, the side unrolled three times around and twice up, the foot a
 * disc of its own in the texture. Positions #V×3, uvs #V×2 (v upward), indices #F×3.
 */
export function roundJar({ around = 256, along = 168, inFoot = 14 } = {}) {
  const positions = [];
  const uvs = [];
  const indices = [];
  const grid = (rows, place, uv) => {
    const first = positions.length / 3;
    for (let row = 0; row <= rows; row++)
      for (let column = 0; column <= around; column++) {
        // The seam's two sides are one place to the bit.
        const angle = tau * ((column % around) / around);
        const [r, y] = place(row / rows);
        positions.push(r * Math.sin(angle), y, r * Math.cos(angle));
        uvs.push(...uv(row / rows, column / around, r, angle));
      }
    const at = (row, column) => first + row * (around + 1) + column;
    for (let row = 0; row < rows; row++)
      for (let column = 0; column < around; column++) {
        const [a, b, c, d] = [
          at(row, column),
          at(row, column + 1),
          at(row + 1, column + 1),
          at(row + 1, column),
        ];
        const isAroundPole = place(row / rows)[0] === 0;
        indices.push(...(isAroundPole ? [] : [a, b, c]), a, c, d);
      }
  };
  const foot = jarProfile(0)[0];
  grid(
    inFoot,
    (t) => [foot * t, jarProfile(0)[1]],
    (_, __, r, angle) => [0.5 + 0.8 * r * Math.sin(angle), 0.5 + 0.8 * r * Math.cos(angle)],
  );
  grid(along, jarProfile, (t, turn) => [3 * turn, 2 * t]);
  return {
    positions: Float32Array.from(positions),
    uvs: Float32Array.from(uvs),
    indices: Uint32Array.from(indices),
  };
}

/** Radius and height along the side of the jar, from the foot to the rim. */
function jarProfile(t) {
  const y = 1.7 * (t - 0.04 * Math.sin(tau * t)) - 0.85;
  const belly = 0.36 + 0.4 * Math.sin(Math.PI * Math.min(1, 0.06 + 1.02 * t) ** 0.86) ** 0.9;
  return [belly + 0.16 * t ** 9, y];
}

/** A trefoil knot of changing girth with a colour at every vertex. PLY. */
export function pebbleKnot({ around = 32, along = 320 } = {}) {
  const vertices = [];
  for (let i = 0; i < along; i++) {
    const { centre, side, up } = knotFrame(tau * (i / along));
    const girth = 0.3 + 0.05 * Math.cos((3 * tau * i) / along);
    for (let j = 0; j < around; j++) {
      const angle = tau * (j / around);
      const point = centre.map(
        (c, axis) => c + girth * (Math.cos(angle) * side[axis] + Math.sin(angle) * up[axis]),
      );
      vertices.push(`${point.map(fixed).join(' ')} ${glaze(i / along, j / around).join(' ')}`);
    }
  }
  const at = (i, j) => (i % along) * around + (j % around);
  const faces = [];
  for (let i = 0; i < along; i++)
    for (let j = 0; j < around; j++) {
      faces.push(
        `3 ${at(i, j)} ${at(i + 1, j + 1)} ${at(i, j + 1)}`,
        `3 ${at(i, j)} ${at(i + 1, j)} ${at(i + 1, j + 1)}`,
      );
    }
  return [
    'ply',
    'format ascii 1.0',
    'comment Pebble knot, made for Whittle. CC0 1.0',
    `element vertex ${vertices.length}`,
    ...['x', 'y', 'z'].map((axis) => `property float ${axis}`),
    ...['red', 'green', 'blue'].map((band) => `property uchar ${band}`),
    `element face ${faces.length}`,
    'property list uchar int vertex_indices',
    'end_header',
    ...vertices,
    ...faces,
    '',
  ].join('\n');
}

function knotPoint(t) {
  return [Math.sin(t) + 2 * Math.sin(2 * t), Math.cos(t) - 2 * Math.cos(2 * t), -1.15 * Math.sin(3 * t)].map(
    (x) => x / 2,
  );
}

function knotFrame(t) {
  const centre = knotPoint(t);
  const tangent = unit(difference(knotPoint(t + 1e-4), knotPoint(t - 1e-4)));
  const side = unit(cross(tangent, [0, 0, 1]));
  return { centre, side, up: cross(side, tangent) };
}

/** From sea green to sand along the knot, lighter on top. */
function glaze(t, s) {
  const warm = 0.5 + 0.5 * Math.cos(tau * t * 3);
  const light = 0.9 + 0.1 * Math.sin(tau * s);
  return [70 + 160 * warm, 150 + 25 * warm, 150 - 45 * warm].map((band) => Math.round(band * light));
}

const fixed = (x) => x.toFixed(6);
const difference = (a, b) => a.map((x, i) => x - b[i]);
const unit = (a) => a.map((x) => x / Math.hypot(...a));
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
