/** What can be shown on the meshes: nodal stresses as they come, and what follows from them. */

/** @typedef {import('../types.js').Mesh} Mesh */
/** @typedef {import('../types.js').Scalar} Scalar */
/** @typedef {'von_mises' | 'equivalent_plastic_strain' | 'tau_max' | 'sigma_1' | 'sigma_2' | 'sigma_3' | 'mean_stress' | 'sigma_x' | 'sigma_y' | 'sigma_z' | 'tau_xy' | 'displacement_x' | 'displacement_y'} Quantity */
/** @typedef {{name: string, round?: string, kind: 'stress' | 'length' | 'strain', signed?: boolean, odd?: boolean}} Kind `round`: its name in axisymmetry; `odd`: changes its sign across the plane of symmetry */

/** @type {Record<Quantity, Kind>} */
export const QUANTITIES = {
  von_mises: { name: 'von Mises stress', kind: 'stress' },
  equivalent_plastic_strain: { name: 'plastic strain', kind: 'strain' },
  tau_max: { name: 'largest shear stress τmax', kind: 'stress' },
  sigma_1: { name: 'largest principal stress σ1', kind: 'stress', signed: true },
  sigma_2: { name: 'middle principal stress σ2', kind: 'stress', signed: true },
  sigma_3: { name: 'least principal stress σ3', kind: 'stress', signed: true },
  mean_stress: { name: 'hydrostatic stress', kind: 'stress', signed: true },
  sigma_x: { name: 'σx', round: 'σr', kind: 'stress', signed: true },
  sigma_y: { name: 'σy', round: 'σz', kind: 'stress', signed: true },
  sigma_z: { name: 'σz', round: 'σθ', kind: 'stress', signed: true },
  tau_xy: { name: 'τxy', round: 'τrz', kind: 'stress', signed: true, odd: true },
  displacement_x: {
    name: 'displacement ux',
    round: 'displacement ur',
    kind: 'length',
    signed: true,
    odd: true,
  },
  displacement_y: {
    name: 'displacement uy',
    round: 'displacement uz',
    kind: 'length',
    signed: true,
  },
};

/** @param {Quantity} quantity @param {string} analysis @returns {string} */
export const nameOf = (quantity, analysis) => {
  const { name, round } = QUANTITIES[quantity];
  const section = sectionOf(analysis);
  if (section)
    return name.replace(/(?<=[στ])[xyz]{1,2}/, (axes) =>
      [...axes]
        .map((axis) => section[axis])
        .sort()
        .join(''),
    );
  return analysis === 'axisymmetric' ? (round ?? name) : name;
};

/** What the axes of a section of half-spaces are in three dimensions; with a prime where they are not the job's. @param {string} analysis @returns {Record<string, string> | undefined} nothing of other analyses */
export function sectionOf(analysis) {
  const [, axis, prime] = /^section_([xy])(′?)$/.exec(analysis) ?? [];
  if (!axis) return undefined;
  return { x: axis + prime, y: 'z', z: (axis === 'x' ? 'y' : 'x') + prime };
}

/** What can be shown of an analysis: of half-spaces no displacements are known. @param {string} analysis */
export const quantitiesOf = (analysis) =>
  /** @type {Quantity[]} */ (Object.keys(QUANTITIES)).filter(
    (quantity) => !sectionOf(analysis) || QUANTITIES[quantity].kind !== 'length',
  );

/**
 * What a value on the right is to be taken by on this side: across the plane of symmetry shear and
 * lateral displacement change their sign; in axisymmetry r points outward on both sides.
 * @param {Quantity} quantity @param {string} analysis @param {1 | -1} side @returns {1 | -1}
 */
export const parityOf = (quantity, analysis, side) =>
  QUANTITIES[quantity].odd && analysis !== 'axisymmetric' ? side : 1;

/** Both principal stresses in the plane, the larger first. @param {number} x @param {number} y @param {number} xy @returns {[number, number]} */
function inPlane(x, y, xy) {
  const [middle, radius] = [(x + y) / 2, Math.hypot((x - y) / 2, xy)];
  return [middle + radius, middle - radius];
}

/** What follows from the stresses at a point. @type {Partial<Record<Quantity, (x: number, y: number, z: number, xy: number) => number>>} */
const OF_STRESSES = {
  sigma_1: (x, y, z, xy) => Math.max(inPlane(x, y, xy)[0], z),
  sigma_3: (x, y, z, xy) => Math.min(inPlane(x, y, xy)[1], z),
  sigma_2: (x, y, z, xy) => {
    const [most, least] = inPlane(x, y, xy);
    return Math.max(Math.min(most, z), Math.min(Math.max(most, z), least));
  },
  tau_max: (x, y, z, xy) => {
    const [most, least] = inPlane(x, y, xy);
    return (Math.max(most, z) - Math.min(least, z)) / 2;
  },
  mean_stress: (x, y, z) => (x + y + z) / 3,
};
/** @type {Scalar[]} */
const STRESSES = ['sigma_x', 'sigma_y', 'sigma_z', 'tau_xy'];

/** @param {Quantity} quantity @returns {Scalar[]} arrays that it is made of, besides displacements */
export function arraysOf(quantity) {
  if (quantity in OF_STRESSES) return STRESSES;
  return quantity === 'displacement_x' || quantity === 'displacement_y'
    ? []
    : [/** @type {Scalar} */ (quantity)];
}

/**
 * @param {Mesh} mesh with the arrays that the quantity is made of
 * @param {Quantity} quantity
 * @param {number} moved how far the body's support moves up, the lower one's being at rest
 * @returns {(node: number) => number} its value at a node
 */
export function valueOf(mesh, quantity, moved) {
  const { displacement } = mesh;
  if (quantity === 'displacement_x') return (node) => displacement[2 * node];
  if (quantity === 'displacement_y') return (node) => displacement[2 * node + 1] + moved;
  const arrays = arraysOf(quantity).map((name) => mesh[name]);
  if (!arrays.every((array) => array !== undefined))
    throw new Error(`${quantity} has not been fetched`);
  const of = OF_STRESSES[quantity];
  const [first, second, third, last] = arrays;
  return of
    ? (node) => of(first[node], second[node], third[node], last[node])
    : (node) => first[node];
}

/** What was made last of a mesh: more of it would be as large as the mesh itself. */
const made = /** @type {WeakMap<Mesh, {quantity: Quantity, values: Float32Array}>} */ (
  new WeakMap()
);

/**
 * @param {Mesh} mesh with the arrays that the quantity is made of
 * @param {Quantity} quantity
 * @param {number} moved how far the body's support moves up, the lower one's being at rest
 * @returns {Float32Array} at every node
 */
export function valuesOf(mesh, quantity, moved) {
  const there = /** @type {any} */ (mesh)[quantity];
  if (there) return there;
  const kept = made.get(mesh);
  if (kept?.quantity === quantity) return kept.values;
  const value = valueOf(mesh, quantity, moved);
  const values = new Float32Array(mesh.nodes.length / 2);
  for (let node = 0; node < values.length; node++) values[node] = value(node);
  made.set(mesh, { quantity, values });
  return values;
}
