/** What a job is made of: the fields of every shape, hardening law and setting, and sensible values to begin with. */

/** @typedef {import('../lib/units.js').Quantity} Quantity */
/**
 * @typedef {object} Field
 * @property {string} key below its parent's pointer
 * @property {string} label
 * @property {string} [symbol]
 * @property {Quantity | 'load'} [quantity] `load`: a force, in the unit of the analysis
 * @property {'number' | 'list' | 'points' | 'choice' | 'flag' | 'tags'} [kind] `number` unless said otherwise
 * @property {Record<string, string>} [choices] value: label
 * @property {string} [hint]
 * @property {string} [help] key of its explanation, where it is not its own
 * @property {[Quantity, Quantity]} [pair] quantities of points
 */
/** @typedef {{label: string, fields: Field[]}} Kind */

/** @type {Record<string, Kind>} */
export const SHAPES = {
  cylinder: { label: 'Cylinder', fields: [{ key: 'radius', label: 'Radius', symbol: 'R', quantity: 'length' }] },
  block: {
    label: 'Block',
    fields: [
      { key: 'width', label: 'Width', symbol: 'w', quantity: 'length' },
      { key: 'depth', label: 'Depth', symbol: 'd', quantity: 'length' },
    ],
  },
  groove: {
    label: 'Groove',
    fields: [
      { key: 'radius', label: 'Radius', symbol: 'R', quantity: 'length' },
      { key: 'width', label: 'Width', symbol: 'w', quantity: 'length' },
      { key: 'depth', label: 'Depth', symbol: 'd', quantity: 'length' },
    ],
  },
  profile: {
    label: 'Profile',
    fields: [
      {
        key: 'points',
        label: 'Points',
        symbol: 'x, height',
        kind: 'points',
        pair: ['length', 'length'],
        hint: 'One point a line, x rising and passing 0; paste from a spreadsheet.',
      },
      { key: 'depth', label: 'Depth', symbol: 'd', quantity: 'length' },
    ],
  },
};

/** @type {Record<string, Kind>} */
export const LAWS = {
  elastic: { label: 'Elastic', fields: [] },
  bilinear: {
    label: 'Bilinear',
    fields: [
      { key: 'yield_stress', label: 'Yield stress', symbol: 'σ_y', quantity: 'stress' },
      {
        key: 'tangent_modulus',
        label: 'Tangent modulus',
        symbol: 'E_t',
        quantity: 'stress',
        hint: '0 is perfectly plastic.',
      },
    ],
  },
  ramberg_osgood: {
    label: 'Ramberg–Osgood',
    fields: [
      { key: 'reference_stress', label: 'Reference stress', symbol: 'σ_0', quantity: 'stress' },
      { key: 'offset', label: 'Offset', symbol: 'a', quantity: 'number', hint: 'ε_p = a (σ_0/E)(q/σ_0)^m' },
      { key: 'exponent', label: 'Exponent', symbol: 'm', quantity: 'number' },
    ],
  },
  swift: {
    label: 'Swift',
    fields: [
      { key: 'yield_stress', label: 'Yield stress', symbol: 'σ_y', quantity: 'stress' },
      {
        key: 'strain_offset',
        label: 'Strain offset',
        symbol: 'ε_0',
        quantity: 'strain',
        hint: 'q = σ_y (1 + ε_p/ε_0)^n',
      },
      { key: 'exponent', label: 'Exponent', symbol: 'n', quantity: 'number' },
    ],
  },
  ludwik: {
    label: 'Ludwik',
    fields: [
      { key: 'yield_stress', label: 'Yield stress', symbol: 'σ_y', quantity: 'stress' },
      { key: 'coefficient', label: 'Coefficient', symbol: 'k', quantity: 'stress', hint: 'q = σ_y + k ε_p^n' },
      { key: 'exponent', label: 'Exponent', symbol: 'n', quantity: 'number' },
    ],
  },
  voce: {
    label: 'Voce',
    fields: [
      { key: 'yield_stress', label: 'Yield stress', symbol: 'σ_y', quantity: 'stress' },
      {
        key: 'saturation_stress',
        label: 'Saturation',
        symbol: 'σ_s',
        quantity: 'stress',
        hint: 'q = σ_y + (σ_s − σ_y)(1 − exp(−b ε_p))',
      },
      { key: 'rate', label: 'Rate', symbol: 'b', quantity: 'number' },
    ],
  },
  table: {
    label: 'Table',
    fields: [
      {
        key: 'points',
        label: 'Points',
        symbol: 'ε_p, q',
        kind: 'points',
        pair: ['strain', 'stress'],
        hint: 'One point a line, from ε_p = 0, never falling; paste from a spreadsheet.',
      },
    ],
  },
  rigid: { label: 'Rigid', fields: [] },
};

/** @type {Field[]} */
export const ELASTIC = [
  { key: 'young_modulus', label: 'Young’s modulus', symbol: 'E', quantity: 'stress' },
  { key: 'poisson_ratio', label: 'Poisson’s ratio', symbol: 'ν', quantity: 'number' },
];

/** @type {Record<string, {label: string, field?: Field}>} */
export const LOADS = {
  force: { label: 'Force', field: { key: 'force', label: 'Force', symbol: 'P', quantity: 'load' } },
  forces: {
    label: 'Sweep of forces',
    field: {
      key: 'forces',
      label: 'Forces',
      symbol: 'P',
      quantity: 'load',
      kind: 'list',
      hint: 'Separated by spaces; 100…1200/12 makes twelve.',
    },
  },
  approach: { label: 'Approach', field: { key: 'approach', label: 'Approach', symbol: 'α', quantity: 'length' } },
  approaches: {
    label: 'Sweep of approaches',
    field: {
      key: 'approaches',
      label: 'Approaches',
      symbol: 'α',
      quantity: 'length',
      kind: 'list',
      hint: 'Separated by spaces; 0.002…0.02/10 makes ten.',
    },
  },
  onset: { label: 'Onset of yield' },
};

/** @type {Record<string, string>} */
export const ANALYSES = { plane_strain: 'Plane strain', plane_stress: 'Plane stress', axisymmetric: 'Axisymmetric' };
/** @type {Record<string, string>} */
export const UNIT_SYSTEMS = { mm_N_MPa: 'mm, N, MPa', SI: 'm, N, Pa' };
/** @type {Record<string, string>} */
export const SUPPORTS = { clamped: 'Clamped', roller: 'Roller' };

/** @type {Field[]} */
export const SETTINGS = [
  { key: 'mesh/elements_per_half_width', label: 'Elements per half-width', quantity: 'number' },
  {
    key: 'solver/coupling',
    label: 'Coupling',
    kind: 'choice',
    choices: { accelerated: 'Accelerated', strong: 'Strong', weak: 'Weak', secant_stiffness: 'Secant stiffness' },
  },
  {
    key: 'solver/contact',
    label: 'Contact method',
    kind: 'choice',
    choices: { active_set: 'Active set', simplex: 'Simplex' },
  },
  { key: 'solver/tolerance', label: 'Tolerance', quantity: 'number' },
  { key: 'solver/max_iterations', label: 'Iterations at most', quantity: 'number' },
  { key: 'output/subsurface', label: 'Stresses over depth', kind: 'flag' },
  { key: 'output/fields', label: 'Stress field on the mesh', kind: 'flag' },
  { key: 'tags', label: 'Tags', kind: 'tags', hint: 'One a line, as bearing: NU-210' },
];

/** What the service takes where a job says nothing. */
export const DEFAULTS = {
  '/units': 'mm_N_MPa',
  '/mesh/elements_per_half_width': 20,
  '/solver/coupling': 'accelerated',
  '/solver/contact': 'active_set',
  '/solver/tolerance': 1e-6,
  '/solver/max_iterations': 500,
  '/output/subsurface': true,
  '/output/fields': false,
};

/**
 * A shape of another kind and about the same size.
 * @param {string} type
 * @param {Record<string, any>} old
 * @returns {Record<string, any>}
 */
export function shapeLike(type, old) {
  const size = Number(old?.radius ?? old?.depth) || 20;
  const round = (/** @type {number} */ value) => Number(value.toPrecision(6));
  switch (type) {
    case 'block':
      return { type, width: round(8 * size), depth: round(8 * size) };
    case 'groove':
      return { type, radius: round(2 * size), width: round(2 * size), depth: round(2 * size) };
    case 'profile': {
      const at = (/** @type {number} */ t) => [round(t * size), round((-t * t * size) / 2)];
      return { type, points: [-1, -0.5, -0.2, 0, 0.2, 0.5, 1].map(at), depth: round(2 * size) };
    }
    default:
      return { type, radius: round(size) };
  }
}

/**
 * Plasticity by another law and of about the same strength.
 * @param {string} law
 * @param {Record<string, any>} material
 * @returns {Record<string, any> | undefined}
 */
export function plasticityLike(law, material) {
  const old = material?.plasticity ?? {};
  const modulus = Number(material?.young_modulus) || 210000;
  const strength = Number(old.yield_stress ?? old.reference_stress ?? old.points?.[0]?.[1]) || modulus / 420;
  const round = (/** @type {number} */ value) => Number(value.toPrecision(6));
  switch (law) {
    case 'bilinear':
      return { law, yield_stress: strength, tangent_modulus: round(modulus / 20) };
    case 'ramberg_osgood':
      return { law, reference_stress: strength, offset: 0.3, exponent: 5 };
    case 'swift':
      return { law, yield_stress: strength, strain_offset: 0.002, exponent: 0.2 };
    case 'ludwik':
      return { law, yield_stress: strength, coefficient: strength, exponent: 0.5 };
    case 'voce':
      return { law, yield_stress: strength, saturation_stress: round(1.5 * strength), rate: 50 };
    case 'table':
      return {
        law,
        points: [
          [0, strength],
          [0.01, round(1.2 * strength)],
          [0.05, round(1.5 * strength)],
        ],
      };
    default:
      return undefined;
  }
}

/** @param {Record<string, any> | undefined} material @returns {string} key of {@link LAWS} */
export const lawOf = (material) => (material?.rigid ? 'rigid' : (material?.plasticity?.law ?? 'elastic'));

/** @param {Record<string, any> | undefined} load @returns {string} key of {@link LOADS} */
export const loadOf = (load) => Object.keys(LOADS).find((key) => load && key in load) ?? 'force';

/** @param {Record<string, any> | undefined} material @returns {number | undefined} stress at which flow begins, to be marked */
export function yieldStress(material) {
  const law = material?.plasticity;
  return law?.yield_stress ?? law?.reference_stress ?? law?.points?.[0]?.[1];
}
