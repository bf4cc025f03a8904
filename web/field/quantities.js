/** What can be shown on the meshes: nodal stresses as they come, and what follows from them. */

/** @typedef {import('../types.js').Mesh} Mesh */
/** @typedef {'von_mises' | 'equivalent_plastic_strain' | 'tau_max' | 'sigma_1' | 'sigma_2' | 'sigma_3' | 'mean_stress' | 'sigma_x' | 'sigma_y' | 'sigma_z' | 'tau_xy' | 'displacement_x' | 'displacement_y'} Quantity */
/** @typedef {{name: string, round?: string, kind: 'stress' | 'length' | 'strain', signed?: boolean, odd?: boolean}} Kind `round`: its name in axisymmetry; `odd`: changes its sign across the axis */

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
  displacement_x: { name: 'displacement ux', round: 'displacement ur', kind: 'length', signed: true, odd: true },
  displacement_y: { name: 'displacement uy', round: 'displacement uz', kind: 'length', signed: true },
};

/** @param {Quantity} quantity @param {string} analysis @returns {string} */
export const nameOf = (quantity, analysis) => {
  const { name, round } = QUANTITIES[quantity];
  return analysis === 'axisymmetric' ? (round ?? name) : name;
};

/** @param {Mesh} mesh @param {(x: number, y: number, z: number, xy: number) => number} of @returns {Float32Array} at every node */
function everywhere({ sigma_x, sigma_y, sigma_z, tau_xy }, of) {
  return sigma_x.map((x, k) => of(x, sigma_y[k], sigma_z[k], tau_xy[k]));
}

/** Both principal stresses in the plane, the larger first. @param {number} x @param {number} y @param {number} xy @returns {[number, number]} */
function inPlane(x, y, xy) {
  const [middle, radius] = [(x + y) / 2, Math.hypot((x - y) / 2, xy)];
  return [middle + radius, middle - radius];
}

/** @type {Partial<Record<Quantity, (mesh: Mesh, lift: number) => Float32Array>>} */
const DERIVED = {
  sigma_1: (mesh) => everywhere(mesh, (x, y, z, xy) => Math.max(inPlane(x, y, xy)[0], z)),
  sigma_3: (mesh) => everywhere(mesh, (x, y, z, xy) => Math.min(inPlane(x, y, xy)[1], z)),
  sigma_2: (mesh) =>
    everywhere(mesh, (x, y, z, xy) => {
      const [most, least] = inPlane(x, y, xy);
      return Math.max(Math.min(most, z), Math.min(Math.max(most, z), least));
    }),
  tau_max: (mesh) =>
    everywhere(mesh, (x, y, z, xy) => {
      const [most, least] = inPlane(x, y, xy);
      return (Math.max(most, z) - Math.min(least, z)) / 2;
    }),
  mean_stress: (mesh) => everywhere(mesh, (x, y, z) => (x + y + z) / 3),
  displacement_x: ({ displacement }) =>
    Float32Array.from({ length: displacement.length / 2 }, (_, k) => displacement[2 * k]),
  displacement_y: ({ displacement }, moved) =>
    Float32Array.from({ length: displacement.length / 2 }, (_, k) => displacement[2 * k + 1] + moved),
};

const made = /** @type {WeakMap<Mesh, Map<Quantity, Float32Array>>} */ (new WeakMap());

/**
 * @param {Mesh} mesh
 * @param {Quantity} quantity
 * @param {number} moved how far the body's support moves up, the lower one's being at rest
 * @returns {Float32Array} at every node
 */
export function valuesOf(mesh, quantity, moved) {
  const derive = DERIVED[quantity];
  if (!derive) return /** @type {any} */ (mesh)[quantity];
  const kept = made.get(mesh) ?? new Map();
  made.set(mesh, kept);
  const values = kept.get(quantity) ?? derive(mesh, moved);
  kept.set(quantity, values);
  return values;
}
