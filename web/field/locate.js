/** Which triangle holds a point, and what a nodal field is there. */

/** @typedef {import('../types.js').Mesh} Mesh */
/** @typedef {{nodes: [number, number, number], weights: [number, number, number]}} Place */

/**
 * A corner of one of the two triangles of each element. A million of them are gone through, so
 * that no list is made of three.
 * @param {Uint32Array} elements
 * @param {number} k four times the number of the triangle
 * @param {0 | 1 | 2} which
 * @returns {number} node
 */
export const corner = (elements, k, which) =>
  elements[4 * (k >> 3) + (which && k & 4 ? which + 1 : which)];

/**
 * The triangle under a point of the deformed mesh. One look at every triangle: a millisecond for a
 * hundred thousand.
 * @param {Mesh} mesh
 * @param {number} deformation
 * @param {number} lift of the body in the picture
 * @param {number} x
 * @param {number} y
 * @returns {Place | null}
 */
export function locate({ nodes, displacement, elements }, deformation, lift, x, y) {
  const px = (/** @type {number} */ n) => nodes[2 * n] + deformation * displacement[2 * n];
  const py = (/** @type {number} */ n) =>
    nodes[2 * n + 1] + deformation * displacement[2 * n + 1] + lift;
  for (let k = 0; k < 2 * elements.length; k += 4) {
    const a = corner(elements, k, 0);
    const b = corner(elements, k, 1);
    const c = corner(elements, k, 2);
    const ax = px(a);
    const bx = px(b);
    const cx = px(c);
    if ((x < ax && x < bx && x < cx) || (x > ax && x > bx && x > cx)) continue;
    const ay = py(a);
    const by = py(b);
    const cy = py(c);
    if ((y < ay && y < by && y < cy) || (y > ay && y > by && y > cy)) continue;
    const area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
    const wb = ((x - ax) * (cy - ay) - (cx - ax) * (y - ay)) / area;
    const wc = ((bx - ax) * (y - ay) - (x - ax) * (by - ay)) / area;
    if (wb >= -1e-6 && wc >= -1e-6 && wb + wc <= 1 + 1e-6)
      return { nodes: [a, b, c], weights: [1 - wb - wc, wb, wc] };
  }
  return null;
}

/** @param {Place} place @param {(node: number) => number} value */
export const valueAt = ({ nodes, weights }, value) =>
  weights[0] * value(nodes[0]) + weights[1] * value(nodes[1]) + weights[2] * value(nodes[2]);

/** @param {Place} place @param {Float32Array} vectors two for each node @returns {[number, number]} */
export const vectorAt = ({ nodes, weights }, vectors) =>
  /** @type {[number, number]} */ (
    [0, 1].map((axis) =>
      weights.reduce((sum, weight, k) => sum + weight * vectors[2 * nodes[k] + axis], 0),
    )
  );

/**
 * The triangles under many points of the undeformed mesh, in one look at every triangle: those
 * whose corners all lie on one side of all points are known by a bit of each corner.
 * @param {Mesh} mesh
 * @param {[number, number][]} points
 * @returns {(Place | null)[]}
 */
export function locateAll({ nodes, elements }, points) {
  const found = /** @type {(Place | null)[]} */ (points.map(() => null));
  if (points.length === 0) return found;
  const order = points.map((_, k) => k).sort((a, b) => points[a][0] - points[b][0]);
  const [xs, ys] = [0, 1].map((axis) => Float64Array.from(order, (k) => points[k][axis]));
  const beyond = sidesOf(nodes, points);
  for (let k = 0; k < 2 * elements.length; k += 4) {
    const a = corner(elements, k, 0);
    const b = corner(elements, k, 1);
    const c = corner(elements, k, 2);
    if (beyond[a] & beyond[b] & beyond[c]) continue;
    const ay = nodes[2 * a + 1];
    const by = nodes[2 * b + 1];
    const cy = nodes[2 * c + 1];
    const ax = nodes[2 * a];
    const bx = nodes[2 * b];
    const cx = nodes[2 * c];
    const right = Math.max(ax, bx, cx);
    const area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
    for (let j = firstFrom(xs, Math.min(ax, bx, cx)); j < xs.length && xs[j] <= right; j++) {
      const x = xs[j];
      const y = ys[j];
      const wb = ((x - ax) * (cy - ay) - (cx - ax) * (y - ay)) / area;
      const wc = ((bx - ax) * (y - ay) - (x - ax) * (by - ay)) / area;
      if (wb >= -1e-6 && wc >= -1e-6 && wb + wc <= 1 + 1e-6)
        found[order[j]] ??= { nodes: [a, b, c], weights: [1 - wb - wc, wb, wc] };
    }
  }
  return found;
}

/** On which sides of all points each node lies, a bit for each side. @param {Float32Array} nodes @param {[number, number][]} points */
function sidesOf(nodes, points) {
  const limits = [0, 1].map((axis) => points.map((point) => point[axis]));
  const [[left, bottom], [right, top]] = [
    limits.map((all) => Math.min(...all)),
    limits.map((all) => Math.max(...all)),
  ];
  const beyond = new Uint8Array(nodes.length / 2);
  for (let n = 0; n < beyond.length; n++) {
    const x = nodes[2 * n];
    const y = nodes[2 * n + 1];
    beyond[n] =
      (x < left ? 1 : 0) | (x > right ? 2 : 0) | (y < bottom ? 4 : 0) | (y > top ? 8 : 0);
  }
  return beyond;
}

/** @param {Float64Array} list rising @param {number} x @returns {number} index of the first that is not less */
function firstFrom(list, x) {
  let [low, high] = [0, list.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (list[middle] < x) low = middle + 1;
    else high = middle;
  }
  return low;
}

/**
 * Polygons of the plastic zone with the displacement of every corner, to be drawn at any
 * deformation.
 * @param {[number, number][][]} outline places along the surface, and depths
 * @param {import('./lift.js').Framed} body
 * @param {boolean} mirrored whether the mesh is the right half
 * @returns {{x: number, y: number, u: number, v: number}[][]}
 */
export function carried(outline, { mesh, frame }, mirrored) {
  const points = outline.map((polygon) =>
    polygon.map(([along, depth]) => frame.point(along, depth)),
  );
  const sideOf = (/** @type {number} */ x) => (mirrored && x < 0 ? -1 : 1);
  const places = locateAll(
    mesh,
    points.flat().map(([x, y]) => [sideOf(x) * x, y]),
  ).values();
  return points
    .map((polygon) =>
      polygon.map(([x, y]) => {
        const place = places.next().value ?? null;
        const [u, v] = place ? vectorAt(place, mesh.displacement) : [0, 0];
        return { x, y, u: sideOf(x) * u, v, found: place !== null };
      }),
    )
    .map((polygon) => {
      // A corner on the surface may lie a hair outside the mesh: it goes with its neighbour.
      polygon.forEach((corner, k) => {
        const neighbour = polygon[(k + polygon.length - 1) % polygon.length];
        if (!corner.found && neighbour) [corner.u, corner.v] = [neighbour.u, neighbour.v];
      });
      return polygon;
    });
}
