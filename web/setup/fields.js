/**
 * What a job is made of: the fields of every shape, hardening law and setting, and sensible values
 * to begin with.
 */

import { isObject } from '../lib/kept.js';
import { numberOf } from '../lib/number.js';
import * as pointer from '../lib/pointer.js';
import { convert, unitsOf } from '../lib/units.js';
import * as tables from './tables.js';

/** @typedef {import('../lib/units.js').Quantity} Quantity */
/** @typedef {import('./field.js').Field} Field */
/** @typedef {import('./field.js').Kind} Kind */

/** @type {Record<string, Kind>} */
export const SHAPES = mapValues(tables.SHAPES, withHints);
for (const field of SHAPES.curved.fields)
  if (field.key.startsWith('radius'))
    field.hint = 'Concave: a negative radius. Straight: left empty.';
// What is said of the width of a block is not so of a plate that is held all round.
for (const field of SHAPES.hole.fields) if (field.key === 'width') field.help = 'plate_width';

/** @type {Record<string, string | undefined>} */
const ANGLES = named({ rotation: '°', angle: '°', tilt: 'mrad' });
for (const { fields } of Object.values(SHAPES))
  for (const field of fields) field.unit = ANGLES[field.key];

/** Profiles of rollers by their names, and the field that each of them alone has. */
const PROFILES = {
  crowned: 'Crowned by an arc',
  logarithmic: 'Logarithmic (Lundberg)',
  iso_16281: 'ISO 16281',
  points: 'Points',
};
/** @type {Record<string, string | undefined>} */
const OF_PROFILE = named({
  crown_radius: 'crowned',
  design_force: 'logarithmic',
  points: 'points',
});
for (const field of SHAPES.roller.fields)
  if (field.key === 'profile')
    Object.assign(field, { choices: PROFILES, none: 'Straight, sharp ends' });

/** @param {Record<string, any> | undefined} shape @returns {Field[]} those that a shape of this kind and profile has */
export const shapeFields = (shape) =>
  (SHAPES[shape?.type]?.fields ?? []).filter(
    ({ key }) =>
      shape?.type !== 'roller' ||
      ((OF_PROFILE[key] ?? shape.profile) === shape.profile &&
        key !== (tiltOf(shape) === 'tilt' ? 'moment' : 'tilt')),
  );

/** How a roller is tilted. @param {Record<string, any> | undefined} shape @returns {'tilt' | 'moment'} the field that says it */
export const tiltOf = (shape) => (shape?.moment === undefined ? 'tilt' : 'moment');

/** Heights that stand on a body. @type {Field[]} */
export const SURFACE = [
  {
    key: 'surface/heights',
    label: 'Heights',
    symbol: 'h',
    quantity: 'length',
    kind: 'heights',
    hint: 'A line for each x, its heights along y; paste a grid, or open text or a NumPy file.',
  },
  { key: 'surface/spacing_x', label: 'Spacing along x', symbol: 'Δx', quantity: 'length' },
  { key: 'surface/spacing_y', label: 'Spacing along y', symbol: 'Δy', quantity: 'length' },
  {
    key: 'surface/detrend',
    label: 'Trend',
    kind: 'choice',
    choices: { none: 'Heights as they are', plane: 'Mean plane taken away' },
  },
];

/** Shapes that have another name when they are turned about the axis. @type {Record<string, string | undefined>} */
const TURNED = named({ cylinder: 'Sphere', hole: 'Socket' });

/** @param {string} type @param {unknown} analysis @returns {string} what a shape is called */
export const shapeLabel = (type, analysis) =>
  (analysis === 'axisymmetric' && TURNED[type]) || SHAPES[type]?.label || 'Body';

/** Shapes of one kind of analysis only, and what stands for them in the other. @type {Record<string, string | undefined>} */
const PLANE_ONLY = named({ wedge: 'cone', cylinder: 'sphere' });
/** @type {Record<string, string | undefined>} */
const TURNED_ONLY = named({ cone: 'wedge', sphere: 'cylinder' });

/** Shapes of half-spaces, which but for a ball are of three dimensions only. */
const OF_HALF_SPACES = new Set(['sphere', 'curved', 'roller', 'flat']);

/** What stands for shapes of sections there, and the other way round. @type {Record<string, string | undefined>} */
const AS_HALF_SPACE = named({ cylinder: 'sphere', parabola: 'sphere', hole: 'curved' });
/** @type {Record<string, string | undefined>} */
const AS_SECTION = named({ curved: 'cylinder', roller: 'cylinder', flat: 'block' });

/** @param {string} type @param {unknown} analysis @returns {string} the same shape, or what stands for it in this analysis */
export function shapeIn(type, analysis) {
  if (analysis === 'three_dimensional')
    return OF_HALF_SPACES.has(type) ? type : (AS_HALF_SPACE[type] ?? 'flat');
  const section = AS_SECTION[type] ?? type;
  return (analysis === 'axisymmetric' ? PLANE_ONLY : TURNED_ONLY)[section] ?? section;
}

/** @param {Record<string, any>} shape @param {unknown} analysis @param {import('../lib/units.js').Units} units @returns {Record<string, any>} what stands for it in this analysis */
export function shapeFor(shape, analysis, units) {
  const type = shapeIn(shape.type, analysis);
  if (type === shape.type) return { ...shape };
  if (type === 'curved') return { type, radius_x: -shape.radius, radius_y: -shape.radius };
  if (type === 'sphere' || type === 'cylinder')
    return { type, radius: shape.radius ?? Math.abs(shape.radius_x ?? shape.radius_y) };
  return OF_HALF_SPACES.has(type) === OF_HALF_SPACES.has(shape.type)
    ? { ...shape, type }
    : shapeLike(type, shape, units);
}

/** @param {unknown} analysis @param {unknown} [own] one that there is already @returns {Record<string, string>} shapes to choose from */
export const shapesFor = (analysis, own) =>
  Object.fromEntries(
    Object.keys(SHAPES)
      .filter(
        (type) =>
          type === own ||
          // A sphere of revolution may be called a cylinder.
          (shapeIn(type, analysis) === type && shapeIn(String(own), analysis) !== type),
      )
      .map((type) => [type, shapeLabel(type, analysis)]),
  );

/** @type {Record<string, Kind>} */
export const LAWS = named({
  elastic: { label: 'Elastic', fields: [] },
  ...mapValues(tables.LAWS, withHints),
  rigid: { label: 'Rigid', fields: [] },
});

/** Ways to give a strength that varies with depth; their keys begin at the hardening law. @type {Record<string, Kind>} */
export const OVER_DEPTH = mapValues(tables.OVER_DEPTH, inVickers);

/** Figures whose symbol is HV are of that scale and of no other. @param {Kind} kind @returns {Kind} */
function inVickers({ fields, ...kind }) {
  const isHardness = (/** @type {string} */ symbol) => /^HV/.test(symbol);
  const scaled = (/** @type {Field} */ { symbol = '', columns, quantity, ...field }) => ({
    ...field,
    symbol,
    columns: columns?.map((one, k) => (isHardness(symbol.split(', ')[k]) ? 'hardness' : one)),
    quantity: isHardness(symbol) ? /** @type {Quantity} */ ('hardness') : quantity,
  });
  return { ...kind, fields: fields.map(scaled) };
}

/**
 * The equation of a law stands below its second field; points can be pasted.
 * @param {Kind} kind
 * @returns {Kind}
 */
function withHints({ fields, ...kind }) {
  const hint = (/** @type {Field} */ field, /** @type {number} */ index) => {
    if (field.kind === 'points') return 'One point a line; paste from a spreadsheet.';
    return index === 1 && kind.description?.includes(' = ') ? kind.description : undefined;
  };
  // Strains may be pasted in per cent.
  const columns = (/** @type {Field['columns']} */ given) =>
    given?.map((one) => (one === 'number' ? 'strain' : one));
  return {
    ...kind,
    fields: fields.map((field, index) => ({
      ...field,
      columns: columns(field.columns),
      hint: hint(field, index),
    })),
  };
}

/**
 * @template T
 * @param {Record<string, T>} record
 * @param {(value: T) => T} change
 * @returns {Record<string, T>}
 */
function mapValues(record, change) {
  return named(
    Object.fromEntries(Object.entries(record).map(([key, value]) => [key, change(value)])),
  );
}

/**
 * A table of nothing but its own names: a job may have any word where one of them is wanted,
 * `constructor` too.
 * @template {object} T
 * @param {T} record
 * @returns {T}
 */
function named(record) {
  return Object.assign(Object.create(null), record);
}

/** Letters of a name. */
const LONGEST = 80;

/** What the job is called, in lists, links, reports and files. @type {Field} */
export const TITLE = { key: 'title', label: 'Title', kind: 'text', longest: LONGEST };

/** What a material is called. @type {Field} */
export const NAME = { key: 'name', label: 'Material’s name', kind: 'text', longest: LONGEST };

/** @type {Field[]} */
export const ELASTIC = [
  { key: 'young_modulus', label: 'Young’s modulus', symbol: 'E', quantity: 'stress' },
  {
    key: 'poisson_ratio',
    label: 'Poisson’s ratio',
    symbol: 'ν',
    quantity: 'number',
    bounds: [0, 0.49],
  },
];

/** Kinematic hardening beside any law. @type {Field} */
export const BACKSTRESS = {
  key: 'backstress',
  label: 'Backstress',
  symbol: 'C, γ',
  kind: 'terms',
  columns: ['stress', 'number'],
  members: ['modulus', 'rate'],
  optional: true,
  hint: 'One term a line, modulus C and rate γ; γ 0 is linear kinematic hardening. None: the yield surface grows without moving.',
};

/** Stress before any load, whatever the material does under it. @type {Field} */
export const INITIAL_STRESS = {
  ...tables.INITIAL_STRESS,
  hint: 'Depth, stress along the surface in the section and out of it, a line each; tension positive.',
};

/** @type {Record<string, {label: string, fields: Field[]}>} */
export const LOADS = {
  force: {
    label: 'Force',
    fields: [{ key: 'force', label: 'Force', symbol: 'P', quantity: 'load' }],
  },
  forces: {
    label: 'Sweep of forces',
    fields: [
      {
        key: 'forces',
        help: 'force',
        label: 'Forces',
        symbol: 'P',
        quantity: 'load',
        kind: 'list',
        hint: 'Separated by spaces; 100…1200/12 makes twelve.',
      },
    ],
  },
  approach: {
    label: 'Approach',
    fields: [{ key: 'approach', label: 'Approach', symbol: 'α', quantity: 'length' }],
  },
  approaches: {
    label: 'Sweep of approaches',
    fields: [
      {
        key: 'approaches',
        help: 'approach',
        label: 'Approaches',
        symbol: 'α',
        quantity: 'length',
        kind: 'list',
        hint: 'Separated by spaces; 0.002…0.02/10 makes ten.',
      },
    ],
  },
  history: {
    label: 'History of loads',
    fields: [
      {
        key: 'history',
        label: 'Loads in turn',
        symbol: 'P',
        quantity: 'load',
        kind: 'history',
        hint: 'Forces one after the other, 0 takes the load away; α0.01 is an approach.',
      },
    ],
  },
  onset: { label: 'Onset of yield', fields: [] },
  target: { label: 'Force for a given figure', fields: [] },
  rolling: {
    label: 'Rolling',
    fields: [
      { key: 'rolling/force', help: 'force', label: 'Force', symbol: 'P', quantity: 'load' },
      {
        key: 'rolling/friction',
        label: 'Friction',
        symbol: 'μ',
        optional: true,
        hint: 'Negative: driven wheel.',
      },
      { key: 'rolling/passes', label: 'Passes', symbol: 'N', optional: true },
      { key: 'rolling/alternating', label: 'There and back', kind: 'flag' },
    ],
  },
  hardness: {
    label: 'Hardness test',
    fields: [{ key: 'hardness', label: 'Test', kind: 'text', hint: 'HBW 10/3000, HV 30, HRC.' }],
  },
};

/** Figures of the contact for which a force can be looked for. @type {Record<string, Field & {example: number}>} */
export const TARGETS = {
  peak_pressure: target('peak_pressure', 'Peak pressure', 'p_max', 'stress', 1200),
  mean_pressure: target('mean_pressure', 'Mean pressure', 'p_m', 'stress', 1000),
  half_width: target('half_width', 'Half-width', 'a', 'length', 0.3),
  max_plastic_strain: target(
    'max_plastic_strain',
    'Largest plastic strain',
    'ε_p',
    'strain',
    0.002,
  ),
  permanent_approach: target('permanent_approach', 'Permanent approach', 'α_p', 'length', 0.002),
  dent_depth: target('dent_depth', 'Depth of the dent', 'δ', 'length', 0.001),
};

/** Both dents together over the diameter of the rolling body, by ISO 76. */
const RATING = 1e-4;

/** What ISO 76 has beside the other figures. */
export const ISO_76 = { key: 'iso_76', label: 'Static rating: 1e-4 of the diameter (ISO 76)' };

/**
 * The permanent approach of ISO 76: ball and raceway together.
 * @param {import('../types.js').Job} job
 * @returns {number | undefined} where a body is round
 */
export function ratedApproach(job) {
  const radii = [job.upper, job.lower].flatMap((body) => {
    const { radius, radius_x: across } = body?.shape ?? {};
    return [numberOf(radius ?? across)].filter((one) => one > 0);
  });
  return radii.length ? Number((2 * RATING * Math.min(...radii)).toPrecision(12)) : undefined;
}

/** @param {string} key @param {string} label @param {string} symbol @param {Quantity} quantity @param {number} example */
function target(key, label, symbol, quantity, example) {
  return { key: `target/${key}`, label, symbol, quantity, example, help: 'target' };
}

/** @type {Record<string, string>} */
export const ANALYSES = {
  plane_strain: 'Plane strain',
  plane_stress: 'Plane stress',
  axisymmetric: 'Axisymmetric',
  three_dimensional: 'Three dimensions',
};

/** @type {Record<string, string>} */
export const UNIT_SYSTEMS = { mm_N_MPa: 'mm, N, MPa', SI: 'm, N, Pa' };
/** @type {Record<string, string>} */
export const THEORIES = { flow: 'Flow theory', deformation: 'Deformation theory' };
/** @type {Record<string, string>} */
export const SUPPORTS = { clamped: 'Clamped', roller: 'Roller' };

/** @type {Field[]} */
export const SETTINGS = [
  { key: 'mesh/elements_per_half_width', label: 'Elements per half-width', quantity: 'number' },
  {
    key: 'mesh/accuracy',
    label: 'Accuracy',
    quantity: 'number',
    kind: 'choice',
    choices: { 0.03: '3 %', 0.01: '1 %', 0.003: '0.3 %' },
    none: 'Mesh as given',
    optional: true,
  },
  { key: 'solver/increments', label: 'Increments a load', quantity: 'number' },
  { key: 'solver/tolerance', label: 'Tolerance', quantity: 'number' },
  { key: 'solver/max_iterations', label: 'Iterations at most', quantity: 'number' },
  { key: 'output/subsurface', label: 'Stresses over depth', kind: 'flag' },
  { key: 'output/fields', label: 'Stress field on the mesh', kind: 'flag' },
  { key: 'output/contact_stiffness', label: 'Contact stiffness where bodies yield', kind: 'flag' },
  { key: 'tags', label: 'Tags', kind: 'tags', hint: 'One a line, as bearing: NU-210' },
];

/** Every field that a form may have. @returns {Field[]} */
export const allFields = () => [
  ...Object.values({ ...SHAPES, ...LAWS, ...OVER_DEPTH }).flatMap(({ fields }) => fields),
  ...ELASTIC,
  BACKSTRESS,
  INITIAL_STRESS,
  ...SURFACE,
  ...SETTINGS,
  ...Object.values(LOADS).flatMap(({ fields }) => fields),
  ...Object.values(TARGETS),
];

/** What the service takes where a job says nothing. */
export const DEFAULTS = {
  '/load/rolling/friction': 0,
  '/load/rolling/passes': 30,
  '/load/rolling/alternating': false,
  '/units': 'mm_N_MPa',
  '/upper/support': 'clamped',
  '/lower/support': 'clamped',
  '/upper/material/plasticity/over_depth/hardness/curve': 'error_function',
  '/lower/material/plasticity/over_depth/hardness/curve': 'error_function',
  '/upper/material/plasticity/over_depth/hardness/hardness_scale': 'HV',
  '/lower/material/plasticity/over_depth/hardness/hardness_scale': 'HV',
  '/upper/surface/detrend': 'none',
  '/lower/surface/detrend': 'none',
  '/mesh/elements_per_half_width': 20,
  '/solver/theory': 'flow',
  '/solver/tolerance': 1e-6,
  '/solver/max_iterations': 500,
  '/output/subsurface': true,
  '/output/fields': false,
  '/output/contact_stiffness': false,
};

/** Elements over each half-width where a job says nothing. @param {import('../types.js').Job} job */
export const usualElements = ({ analysis }) =>
  analysis === 'three_dimensional' ? 10 : DEFAULTS['/mesh/elements_per_half_width'];

/** Examples of the tables are about as large as a cylinder of this radius [mm]. */
const TYPICAL_RADIUS = 20;

/** The first length of a shape, which tells its size. @param {string} type */
const firstLength = (type) =>
  SHAPES[type]?.fields.find(
    ({ quantity, example }) => quantity === 'length' && typeof example === 'number',
  );

/**
 * A shape of another kind and about the same size.
 * @param {string} type
 * @param {Record<string, any> | undefined} old
 * @param {import('../lib/units.js').Units} units of both
 * @returns {Record<string, any>}
 */
export function shapeLike(type, old, units) {
  const first = firstLength(old?.type);
  const times = first && numberOf(old?.[first.key]) / Number(first.example);
  const size = convert(1, 'length', 'mm_N_MPa', units);
  const scale = times && times > 0 ? times : size;
  const round = (/** @type {number} */ value) => Number(value.toPrecision(6));
  const typical = (/** @type {Field} */ { example, quantity }) =>
    typeof example === 'number' && quantity === 'length' ? round(example * scale) : example;
  const fields = SHAPES[type].fields.filter(({ optional }) => !optional);
  const shape = {
    type,
    ...Object.fromEntries(fields.map((field) => [field.key, typical(field)])),
  };
  if (type === 'hole') return { ...shape, outer_radius: round(10 * TYPICAL_RADIUS * scale) };
  if (type !== 'profile') return shape;
  // Points of a parabola, which is smooth between them.
  const at = (/** @type {number} */ t) =>
    [t, (-t * t) / 2].map((one) => round(one * TYPICAL_RADIUS * scale) || 0);
  return { ...shape, points: [-1, -0.5, -0.2, 0, 0.2, 0.5, 1].map(at), interpolation: 'smooth' };
}

/**
 * What a profile of a roller is given by, about as large as such profiles are.
 * @param {string} profile
 * @param {Record<string, any>} roller
 * @param {import('../types.js').Job} job
 * @returns {Record<string, unknown>}
 */
export function profileLike(profile, { length: given }, job) {
  const length = numberOf(given) || convert(10, 'length', 'mm_N_MPa', unitsOf(job));
  const round = (/** @type {number} */ value) => Number(value.toPrecision(6));
  if (profile === 'crowned') return { crown_radius: round(200 * length) };
  if (profile === 'logarithmic') {
    const force = numberOf(job.load?.force);
    return { design_force: force > 0 ? force : convert(5000, 'force', 'mm_N_MPa', unitsOf(job)) };
  }
  const at = [-0.5, -0.35, 0.35, 0.5].map((y, k) => [
    round(y * length),
    k % 3 ? 0 : round(-0.001 * length),
  ]);
  return profile === 'points' ? { points: at } : {};
}

/**
 * A rough patch of 32 × 32 heights for a body: waves of several lengths on a cap, the same every
 * time.
 * @param {import('../lib/units.js').Units} units
 * @returns {{heights: number[][], spacing_x: number, spacing_y: number, detrend: string}}
 */
export function typicalSurface(units) {
  const length = (/** @type {number} */ value) => convert(value, 'length', 'mm_N_MPa', units);
  const many = 32;
  const waves = Array.from({ length: 24 }, (_, k) => {
    const [angle, turns] = [2.4 * k, 1 + 0.3 * k];
    return {
      x: turns * Math.cos(angle),
      y: turns * Math.sin(angle),
      phase: 5.1 * k * k,
      size: turns ** -1.8,
    };
  });
  const height = (/** @type {number} */ i, /** @type {number} */ j) => {
    const sum = waves.reduce(
      (all, { x, y, phase, size }) =>
        all + size * Math.cos((2 * Math.PI * (i * x + j * y)) / many + phase),
      0,
    );
    // Lower towards the rim, beyond which nothing touches.
    return sum - 3 * ((2 * i) / (many - 1) - 1) ** 2 - 3 * ((2 * j) / (many - 1) - 1) ** 2;
  };
  const heights = Array.from({ length: many }, (_, i) =>
    Array.from({ length: many }, (_, j) => Number(length(1.5e-4 * height(i, j)).toPrecision(4))),
  );
  return { heights, spacing_x: length(0.004), spacing_y: length(0.004), detrend: 'plane' };
}

/** @param {Record<string, any> | undefined} body @returns {boolean} whether heights stand on it */
export const hasSurface = (body) => body?.surface !== undefined && body.surface !== null;

/** Young’s modulus of steel. @param {import('../lib/units.js').Units} units */
export const typicalModulus = (units) => convert(STEEL, 'stress', 'mm_N_MPa', units);
/** [MPa] */
const STEEL = 210000;

/**
 * Plasticity by another law and of about the same strength.
 * @param {string} law
 * @param {Record<string, any>} material
 * @param {import('../lib/units.js').Units} units
 * @returns {Record<string, any> | undefined}
 */
export function plasticityLike(law, material, units) {
  if (!LAWS[law]?.fields.length) return undefined;
  const old = material?.plasticity ?? {};
  const modulus = numberOf(material?.young_modulus) || typicalModulus(units);
  const strength =
    numberOf(old.yield_stress ?? old.reference_stress ?? old.points?.[0]?.[1]) || modulus / 420;
  const round = (/** @type {number} */ value) => Number(value.toPrecision(6));
  // Typical figures are those of a steel of 500 MPa; a slope grows with the modulus, a stress with
  // the strength.
  const scaled = (
    /** @type {any} */ value,
    /** @type {string | undefined} */ quantity,
    /** @type {string} */ key,
  ) =>
    quantity !== 'stress'
      ? value
      : round(key.endsWith('modulus') ? (value / STEEL) * modulus : (value / 500) * strength);
  const typical = (/** @type {Field} */ { key, quantity, columns, example }) =>
    Array.isArray(example)
      ? example.map((point) => point.map((value, axis) => scaled(value, columns?.[axis], key)))
      : scaled(example, quantity, key);
  const fields = LAWS[law].fields.filter(({ optional }) => !optional);
  return { law, ...Object.fromEntries(fields.map((field) => [field.key, typical(field)])) };
}

/** @param {Record<string, any> | undefined} material @returns {string} key of {@link LAWS} */
export const lawOf = (material) =>
  material?.rigid ? 'rigid' : (material?.plasticity?.law ?? 'elastic');

/** @param {Record<string, any> | undefined} material @returns {string} key of {@link OVER_DEPTH}, or `uniform` */
export function overDepthOf(material) {
  const given = material?.plasticity?.over_depth;
  if (given === undefined || given === null) return 'uniform';
  if (!isObject(given.hardness)) return 'factors';
  return 'profile' in given.hardness ? 'hardness' : 'case';
}

/**
 * A typical strength over depth, in the units of a job.
 * @param {string} kind
 * @param {import('../lib/units.js').Units} units
 * @returns {unknown}
 */
export function typicalOverDepth(kind, units) {
  const wire = (/** @type {number} */ value, /** @type {string | undefined} */ quantity) =>
    quantity === 'length' ? convert(value, 'length', 'mm_N_MPa', units) : value;
  const fields = (OVER_DEPTH[kind]?.fields ?? []).filter(
    ({ optional, key }) => !optional || key === 'over_depth',
  );
  const plasticity = /** @type {Record<string, any>} */ ({});
  for (const { key, columns, quantity, example } of fields) {
    const value = Array.isArray(example)
      ? example.map((point) => point.map((one, axis) => wire(one, columns?.[axis])))
      : wire(Number(example), quantity);
    pointer.set(plasticity, `/${key}`, value);
  }
  return plasticity.over_depth;
}

/** Its directions have other names in axisymmetry. @param {unknown} analysis @returns {Field} */
export const initialStressOf = (analysis) =>
  analysis === 'axisymmetric'
    ? { ...INITIAL_STRESS, symbol: 'z, σ_r, σ_θ' }
    : analysis === 'three_dimensional'
      ? {
          ...INITIAL_STRESS,
          symbol: 'z, σ_x, σ_y',
          hint: 'Depth, stress along x and along y, a line each; tension positive.',
        }
      : INITIAL_STRESS;

/** @param {Record<string, any> | undefined} material @returns {boolean} */
export const hasInitialStress = (material) =>
  !material?.rigid && material?.initial_stress !== undefined && material.initial_stress !== null;

/** Of a shot-peened layer: depth [mm] and stress [MPa]. */
const PEENED = [
  [0, -450],
  [0.05, -600],
  [0.15, -350],
  [0.25, 40],
  [0.6, 0],
];
/** Part of the yield stress that it reaches at most. */
const PEENED_SHARE = 0.6;

/**
 * A typical stress before any load, in the units of a job.
 * @param {import('../types.js').Job} job
 * @param {Record<string, any> | undefined} material
 * @returns {Record<string, number>[]}
 */
export function typicalInitialStress(job, material) {
  const units = unitsOf(job);
  const strength = yieldStress(material);
  const most =
    strength && strength > 0
      ? convert(strength, 'stress', units, 'mm_N_MPa') * PEENED_SHARE
      : Infinity;
  const share = Math.min(1, most / Math.max(...PEENED.map(([, stress]) => -stress)));
  return PEENED.map(([depth, stress]) => {
    const along = Number(convert(share * stress, 'stress', 'mm_N_MPa', units).toPrecision(3));
    return {
      depth: convert(depth, 'length', 'mm_N_MPa', units),
      sigma_x: along,
      sigma_z: job.analysis === 'plane_stress' ? 0 : along,
    };
  });
}

/** @param {Record<string, any> | undefined} load @returns {string} key of {@link LOADS} */
export const loadOf = (load) =>
  Object.keys(LOADS).find((key) => isObject(load) && key in load) ?? 'force';

/** @param {Record<string, any> | undefined} load @returns {string} key of {@link TARGETS} */
export const targetOf = (load) =>
  Object.keys(TARGETS).find((key) => isObject(load?.target) && key in load.target) ??
  'peak_pressure';

/** @param {Record<string, any> | undefined} material @returns {string} what that stress is: by some laws metal flows from the first load on */
export const yieldName = (material) =>
  material?.plasticity?.reference_stress === undefined ? 'yield' : 'reference stress';

/** @param {Record<string, any> | undefined} material @returns {number | undefined} stress at which flow begins, to be marked */
export function yieldStress(material) {
  const law = material?.plasticity;
  return law?.yield_stress ?? law?.reference_stress ?? law?.points?.[0]?.[1];
}
