/** What a nodal field is along a line through the bodies. */

import { corner, locate, vectorAt } from './locate.js';

/** @typedef {import('../types.js').Mesh} Mesh */
/** @typedef {[number, number]} Point */
/** @typedef {{begin: number, end: number, from: number, to: number, path: [Point, Point]}} Piece of a line within a triangle: distances, values, places in the picture */
/** @typedef {{mesh: Mesh, lift: number}} Drawn a body in the picture */

/** Part of the line that is no gap between triangles. */
const HAIR = 1e-7;

/**
 * The field along a line across a body without load, exact for what is drawn: one piece of every
 * triangle that the line crosses. One look at every triangle.
 * @param {Drawn} body
 * @param {Float32Array} values one for each node
 * @param {number} deformation of the picture
 * @param {1 | -1} side −1 for the mirrored half
 * @param {number} parity factor on values there
 * @param {Point} from
 * @param {Point} to
 * @returns {Piece[]}
 */
export function cut(
  { mesh: { nodes, displacement, elements }, lift },
  values,
  deformation,
  side,
  parity,
  from,
  to,
) {
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
  if (!(length > 0)) return [];
  const [ex, ey] = [(to[0] - from[0]) / length, (to[1] - from[1]) / length];
  const count = nodes.length / 2;
  // Along the line and across it, of every node.
  const [along, across] = [new Float64Array(count), new Float64Array(count)];
  for (let n = 0; n < count; n++) {
    const x = side * nodes[2 * n] - from[0];
    const y = nodes[2 * n + 1] - from[1];
    along[n] = x * ex + y * ey;
    across[n] = y * ex - x * ey;
  }
  const seen = (/** @type {number} */ n) => [
    side * (nodes[2 * n] + deformation * displacement[2 * n]),
    nodes[2 * n + 1] + deformation * displacement[2 * n + 1] + lift,
  ];
  /**
   * Where the line crosses the edges of a triangle: two nodes, and the share of the way from one
   * to the other.
   */
  const crossings = /** @type {[number, number, number][]} */ ([]);
  const edge = (/** @type {number} */ a, /** @type {number} */ b) => {
    if (across[a] > 0 !== across[b] > 0)
      crossings.push([a, b, across[a] / (across[a] - across[b])]);
  };
  const pieces = /** @type {Piece[]} */ ([]);
  for (let k = 0; k < 2 * elements.length; k += 4) {
    const a = corner(elements, k, 0);
    const b = corner(elements, k, 1);
    const c = corner(elements, k, 2);
    if (across[a] > 0 === across[b] > 0 && across[b] > 0 === across[c] > 0) continue;
    crossings.length = 0;
    edge(a, b);
    edge(b, c);
    edge(c, a);
    const at = (/** @type {typeof crossings[0]} */ [a, b, t]) =>
      along[a] + t * (along[b] - along[a]);
    const [first, last] =
      at(crossings[0]) <= at(crossings[1]) ? crossings : [crossings[1], crossings[0]];
    const [near, far] = [at(first), at(last)];
    const [begin, end] = [Math.max(0, near), Math.min(length, far)];
    if (!(end > begin)) continue;
    // What the line has of the triangle between its ends.
    const within = (
      /** @type {number} */ place,
      /** @type {(node: number) => number} */ value,
    ) => {
      const [one, other] = [first, last].map(([a, b, t]) => value(a) + t * (value(b) - value(a)));
      return one + ((place - near) / (far - near)) * (other - one);
    };
    const spot = (/** @type {number} */ place) =>
      /** @type {Point} */ ([0, 1].map((axis) => within(place, (node) => seen(node)[axis])));
    pieces.push({
      begin,
      end,
      from: parity * within(begin, (node) => values[node]),
      to: parity * within(end, (node) => values[node]),
      path: [spot(begin), spot(end)],
    });
  }
  return pieces;
}

/**
 * A curve along pieces, broken where the line leaves the body.
 * @param {Piece[]} pieces
 * @returns {{x: number[], y: (number | null)[]}} distance from the beginning, value
 */
export function curveOf(pieces) {
  const sorted = [...pieces].sort((a, b) => a.begin - b.begin);
  const [x, y] = [/** @type {number[]} */ ([]), /** @type {(number | null)[]} */ ([])];
  const hair = HAIR * (sorted.at(-1)?.end ?? 0);
  for (const { begin, end, from, to } of sorted) {
    const last = x.at(-1) ?? -Infinity;
    if (begin > last + hair) {
      if (x.length) {
        x.push((last + begin) / 2);
        y.push(null);
      }
      x.push(begin);
      y.push(from);
    }
    if (end <= (x.at(-1) ?? 0)) continue;
    x.push(end);
    y.push(to);
  }
  return { x, y };
}

/**
 * Where a place of the picture is in the bodies without load; the place itself beside them.
 * @param {Drawn[]} bodies @param {number} deformation @param {boolean} mirrored @param {Point} place @returns {Point}
 */
export function withoutLoad(bodies, deformation, mirrored, [x, y]) {
  const side = mirrored && x < 0 ? -1 : 1;
  for (const { mesh, lift } of bodies) {
    const found = locate(mesh, deformation, lift, side * x, y);
    if (!found) continue;
    const [px, py] = vectorAt(found, mesh.nodes);
    return [side * px, py];
  }
  return [x, y];
}
