/** What a nodal field is along a line through the bodies. */

import { corner } from './locate.js';

/** @typedef {import('../types.js').Mesh} Mesh */
/** @typedef {[number, number]} Point */

/**
 * The field along a line across a drawn mesh, exact for what is drawn: one point wherever the line crosses an edge. One look at
 * every triangle.
 * @param {{mesh: Mesh, lift: number}} body
 * @param {Float32Array} values one for each node
 * @param {number} deformation
 * @param {1 | -1} side −1 for the mirrored half
 * @param {number} parity factor on values there
 * @param {Point} from
 * @param {Point} to
 * @returns {Point[]} distance from the beginning, value; by distance
 */
export function cut({ mesh: { nodes, displacement, elements }, lift }, values, deformation, side, parity, from, to) {
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
  if (!(length > 0)) return [];
  const [ex, ey] = [(to[0] - from[0]) / length, (to[1] - from[1]) / length];
  const count = nodes.length / 2;
  // Along the line and across it, of every node.
  const [along, across] = [new Float64Array(count), new Float64Array(count)];
  for (let n = 0; n < count; n++) {
    const x = side * (nodes[2 * n] + deformation * displacement[2 * n]) - from[0];
    const y = nodes[2 * n + 1] + deformation * displacement[2 * n + 1] + lift - from[1];
    along[n] = x * ex + y * ey;
    across[n] = y * ex - x * ey;
  }
  const points = /** @type {Point[]} */ ([]);
  const edge = (/** @type {number} */ a, /** @type {number} */ b) => {
    if (across[a] > 0 === across[b] > 0) return;
    const t = across[a] / (across[a] - across[b]);
    const at = along[a] + t * (along[b] - along[a]);
    if (at >= 0 && at <= length) points.push([at, parity * (values[a] + t * (values[b] - values[a]))]);
  };
  for (let k = 0; k < 2 * elements.length; k += 4) {
    const a = corner(elements, k, 0);
    const b = corner(elements, k, 1);
    const c = corner(elements, k, 2);
    if (across[a] > 0 === across[b] > 0 && across[b] > 0 === across[c] > 0) continue;
    edge(a, b);
    edge(b, c);
    edge(c, a);
  }
  points.sort((a, b) => a[0] - b[0]);
  // Neighbours share their edges.
  return points.filter(([at], k) => k === 0 || at - points[k - 1][0] > 1e-9 * length);
}
