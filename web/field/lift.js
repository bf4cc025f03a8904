/**
 * How far each body is raised in the picture. Displacements are exaggerated about the middle of
 * the contact, and the upper body is raised by what the exaggeration would push it into the lower
 * one: bodies that touch are drawn side by side, never overlapping.
 */

/** @typedef {import('../types.js').Mesh} Mesh */
/** @typedef {import('./frame.js').Frame} Frame */
/** @typedef {{mesh: Mesh, frame: Frame}} Framed */
/**
 * @typedef {object} Lifts
 * @property {number} upper
 * @property {number} lower
 * @property {number} contact height at which the middle of the contact is drawn
 * @property {number} unloaded height of the middle of the contact in the bodies without load
 */

/**
 * Nodes of a surface at the places of the contact pairs.
 * @param {Framed} body
 * @param {number[]} places of the pairs along the surface, rising
 * @returns {Int32Array} node of each place; −1 where there is none
 */
export function surfaceNodes({ mesh: { nodes }, frame }, places) {
  const found = new Int32Array(places.length).fill(-1);
  const depths = new Float64Array(places.length);
  const [left, right] = [places[0], places[places.length - 1]];
  const slack = 1e-4 * (places.length > 1 ? (right - left) / (places.length - 1) : 1);
  for (let n = 0; n < nodes.length / 2; n++) {
    const [along, depth] = frame.place(nodes[2 * n], nodes[2 * n + 1]);
    if (!(along >= left - slack && along <= right + slack)) continue;
    const k = nearest(places, along);
    if (Math.abs(places[k] - along) > slack) continue;
    if (found[k] >= 0 && depth >= depths[k]) continue;
    found[k] = n;
    depths[k] = depth;
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

/** @typedef {{x: number, y: number, u: number, v: number}} Moved a node and its displacement */

/** @param {Framed | null} body @param {Int32Array | null} surface @param {number} k @returns {Moved} */
function movedAt(body, surface, k) {
  if (!body || !surface || k < 0) return { x: 0, y: 0, u: 0, v: 0 };
  const [n, { nodes, displacement }] = [2 * surface[k], body.mesh];
  return { x: nodes[n], y: nodes[n + 1], u: displacement[n], v: displacement[n + 1] };
}

/**
 * The surface of a body between the contact pairs, with its displacement.
 * @param {Framed} body
 * @param {number[]} places of the pairs along the surface, rising
 * @returns {(along: number) => Moved | undefined}
 */
export function surfaceOf(body, places) {
  const found = surfaceNodes(body, places);
  const points = places.flatMap((place, k) =>
    found[k] >= 0 ? [{ place, ...movedAt(body, found, k) }] : [],
  );
  return (along) => {
    const beyond = points.findIndex(({ place }) => place >= along);
    const next = beyond < 0 ? points.length - 1 : Math.max(1, beyond);
    const [one, other] = [points[next - 1], points[next]];
    if (!one || !other) return undefined;
    const t = (along - one.place) / (other.place - one.place);
    const between = (/** @type {keyof Moved} */ part) => one[part] + t * (other[part] - one[part]);
    return { x: between('x'), y: between('y'), u: between('u'), v: between('v') };
  };
}

/**
 * @param {Framed | null} upper
 * @param {Framed | null} lower
 * @param {number[]} places of the contact pairs
 * @param {number} peak place of the largest pressure
 * @param {number} approach by which the upper body is lowered
 * @returns {(deformation: number) => Lifts}
 */
export function lifts(upper, lower, places, peak, approach) {
  const [above, below] = [upper, lower].map((body) => body && surfaceNodes(body, places));
  const there = places
    .map((_, k) => k)
    .filter((k) => [above, below].every((surface) => !surface || surface[k] >= 0));
  const fromPeak = (/** @type {number} */ k) => Math.abs(places[k] - peak);
  const middle = there.reduce((a, b) => (fromPeak(b) < fromPeak(a) ? b : a), there[0] ?? -1);
  const [up, low] = [movedAt(upper, above, middle), movedAt(lower, below, middle)];
  // Kept by themselves: the meshes may be given back before they are drawn for the last time.
  const pairs =
    upper && lower
      ? there.map((k) => ({
          one: movedAt(upper, above, k),
          other: movedAt(lower, below, k),
          normal: lower.frame.outward(places[k]),
        }))
      : [];
  return (f) => {
    const lifted = { upper: -approach - (f - 1) * up.v, lower: -(f - 1) * low.v };
    if (!upper) return { ...lifted, contact: low.y + f * low.v + lifted.lower, unloaded: low.y };
    if (!lower) return { ...lifted, contact: up.y + f * up.v + lifted.upper, unloaded: up.y };
    let overlap = 0;
    if (f > 1)
      for (const { one, other, normal } of pairs) {
        // Along the normal, and what the upper body has to rise to be clear of that.
        const [across, upward] = normal;
        const into =
          across * (other.x + f * other.u - one.x - f * one.u) +
          upward * (other.y + f * other.v + lifted.lower - one.y - f * one.v - lifted.upper);
        overlap = Math.max(overlap, into / upward);
      }
    lifted.upper += overlap;
    return { ...lifted, contact: low.y + f * low.v + lifted.lower + overlap / 2, unloaded: low.y };
  };
}
