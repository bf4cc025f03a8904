/**
 * How far each body is raised in the picture. Displacements are exaggerated about the middle of the contact, and the upper body
 * is raised by what the exaggeration would push it into the lower one: bodies that touch are drawn side by side, never overlapping.
 */

/** @typedef {import('../types.js').Mesh} Mesh */
/** @typedef {{upper: number, lower: number, contact: number}} Lifts `contact`: height at which the middle of the contact is drawn */

/**
 * Nodes of a surface at the places of the contact pairs.
 * @param {Mesh} mesh
 * @param {number[]} places x of the pairs, rising
 * @param {1 | -1} outward 1 where the surface is the top of the body
 * @returns {Int32Array} node of each place; −1 where there is none
 */
export function surfaceNodes({ nodes }, places, outward) {
  const found = new Int32Array(places.length).fill(-1);
  const [left, right] = [places[0], places[places.length - 1]];
  const slack = 1e-4 * (places.length > 1 ? (right - left) / (places.length - 1) : 1);
  for (let n = 0; n < nodes.length / 2; n++) {
    if (!(nodes[2 * n] >= left - slack && nodes[2 * n] <= right + slack)) continue;
    const k = nearest(places, nodes[2 * n]);
    if (Math.abs(places[k] - nodes[2 * n]) > slack) continue;
    if (found[k] < 0 || outward * (nodes[2 * n + 1] - nodes[2 * found[k] + 1]) > 0) found[k] = n;
  }
  return found;
}

/** @param {number[]} list rising @param {number} x */
function nearest(list, x) {
  let [low, high] = [0, list.length - 1];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (list[middle] > x) high = middle;
    else low = middle;
  }
  return x - list[low] < list[high] - x ? low : high;
}

/**
 * @param {Mesh | null | undefined} upper
 * @param {Mesh | null | undefined} lower
 * @param {import('../types.js').Step} step
 * @returns {(deformation: number) => Lifts}
 */
export function lifts(upper, lower, { approach, contact: { nodes } }) {
  const surfaces = [upper && surfaceNodes(upper, nodes.x, -1), lower && surfaceNodes(lower, nodes.x, 1)];
  const there = nodes.x.map((_, k) => k).filter((k) => surfaces.every((surface) => !surface || surface[k] >= 0));
  const middle = there.reduce((a, b) => (nodes.pressure[b] > nodes.pressure[a] ? b : a), there[0] ?? -1);
  /** @param {Mesh | null | undefined} mesh @param {Int32Array | null | undefined} surface @param {number} k @returns {[number, number]} height and displacement */
  const at = (mesh, surface, k) =>
    mesh && surface && k >= 0 ? [mesh.nodes[2 * surface[k] + 1], mesh.displacement[2 * surface[k] + 1]] : [0, 0];
  return (f) => {
    const [[hu, vu], [hl, vl]] = [at(upper, surfaces[0], middle), at(lower, surfaces[1], middle)];
    let [up, low] = [-approach - (f - 1) * vu, -(f - 1) * vl];
    if (!upper) return { upper: up, lower: low, contact: hl + f * vl + low };
    if (!lower) return { upper: up, lower: low, contact: hu + f * vu + up };
    let overlap = 0;
    if (f > 1)
      for (const k of there) {
        const [[yu, du], [yl, dl]] = [at(upper, surfaces[0], k), at(lower, surfaces[1], k)];
        overlap = Math.max(overlap, yl + f * dl + low - (yu + f * du + up));
      }
    up += overlap;
    return { upper: up, lower: low, contact: hl + f * vl + low + overlap / 2 };
  };
}
