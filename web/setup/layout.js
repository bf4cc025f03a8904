/** Which fields the form has for a job, in their order: a function of the job alone. */

import { isObject } from '../lib/kept.js';
import * as pointer from '../lib/pointer.js';
import { plain } from '../lib/units.js';
import {
  ANALYSES,
  BACKSTRESS,
  ELASTIC,
  ISO_76,
  LAWS,
  LOADS,
  NAME,
  OVER_DEPTH,
  SETTINGS,
  SUPPORTS,
  SURFACE,
  TARGETS,
  THEORIES,
  TITLE,
  UNIT_SYSTEMS,
  hasInitialStress,
  hasSurface,
  initialStressOf,
  lawOf,
  loadOf,
  overDepthOf,
  ratedApproach,
  shapeFields,
  shapesFor,
  targetOf,
  tiltOf,
} from './fields.js';

/** @typedef {import('../types.js').Job} Job */
/** @typedef {import('./field.js').Field} Field */
/** @typedef {'upper' | 'lower'} Body */
/** @typedef {'title' | 'general' | Body | 'load' | 'settings'} Part */
/** @typedef {'press' | 'raceway' | 'rolling' | 'hardness' | 'surface' | 'depth'} Door */
/**
 * @typedef {{part: Part, place: string, field?: Field}} Place without a field what a body always has
 */

/** @param {Job} job @returns {Place[]} */
export const layoutOf = (job) => [
  ...fields('title', '', [TITLE]),
  choice('general', '/analysis', 'Analysis', ANALYSES),
  choice('general', '/units', 'Units', UNIT_SYSTEMS),
  ...['upper', 'lower'].flatMap((body) => ofBody(job, /** @type {Body} */ (body))),
  ...ofLoad(job),
  ...fields('settings', '', SETTINGS.map(withOwn(job))),
];

/** A choice among figures has that of the job too. @param {Job} job @returns {(field: Field) => Field} */
const withOwn = (job) => (field) => {
  const own = pointer.get(job, `/${field.key}`);
  return typeof own === 'number' && field.choices && !(own in field.choices)
    ? { ...field, choices: { ...field.choices, [own]: `${plain(100 * own)} %` } }
    : field;
};

/** What a job is about. @param {Job} job @returns {Door} */
export function doorOf(job) {
  const bodies = [job.upper, job.lower];
  const kind = loadOf(job.load);
  if (kind === 'hardness' || kind === 'rolling') return kind;
  if (bodies.some(hasSurface)) return 'surface';
  const varies = (/** @type {any} */ body) =>
    overDepthOf(body?.material) !== 'uniform' || hasInitialStress(body?.material);
  if (bodies.some(varies)) return 'depth';
  return job.analysis === 'three_dimensional' ? 'raceway' : 'press';
}

/** With these every form begins, and with these by what the job is about. */
const FIRST =
  /^\/(analysis|units|load\b)|\/shape\/|\/plasticity\/(yield_stress|reference_stress|points)$/;
/** @type {Record<Door, RegExp>} */
const BY_DOOR = {
  press: /$^/,
  raceway: /\/shape\/(profile|tilt)/,
  rolling: /\/backstress$/,
  hardness: /\/plasticity\/(?!backstress)/,
  surface: /\/surface/,
  depth: /\/(depth_kind|stress_kind)$/,
};
/** What every job has stands behind “more” whatever it is. */
const GIVEN = /\/(tags|name|young_modulus|poisson_ratio|law|output\/.*)$|\/plasticity\/[^/]*$/;
/** What a job that says nothing has. @type {Record<string, unknown>} */
const USUAL = { depth_kind: 'uniform', stress_kind: 'none', surface_kind: 'none' };

/**
 * Whether the form begins with a field: others stand behind “more” for as long as they are as usual.
 * @param {Job} job
 * @param {Place} place
 * @param {unknown} value of the job there
 * @param {unknown} usual what holds without one
 */
export const isFirst = (job, { place, field }, value, usual) =>
  (FIRST.test(place) &&
    (!field?.optional || place.startsWith('/load/')) &&
    !(field && isOverruled(job[place.split('/')[1]]?.material, field))) ||
  BY_DOOR[doorOf(job)].test(place) ||
  (!GIVEN.test(place) && value != null && value !== (usual ?? USUAL[field?.key ?? '']));

/** Whether hardness over depth stands in place of a figure of the law. @param {any} material @param {Field} field */
const isOverruled = (material, { key }) =>
  ['hardness', 'case'].includes(overDepthOf(material)) &&
  (key === 'yield_stress' || key === 'reference_stress');

/** @param {Part} part @param {string} parent @param {Field[]} all @returns {Place[]} */
const fields = (part, parent, all) =>
  all.map((field) => ({ part, place: `${parent}/${field.key}`, field }));

/** @param {Part} part @param {string} place @param {string} label @param {Record<string, string>} choices @returns {Place} */
const choice = (part, place, label, choices) => ({
  part,
  place,
  field: { key: place.slice(place.lastIndexOf('/') + 1), label, kind: 'choice', choices },
});

/** Words of a table of kinds. @param {Record<string, {label: string}>} kinds */
const labels = (kinds) =>
  Object.fromEntries(Object.entries(kinds).map(([key, { label }]) => [key, label]));

/** @param {Job} job @param {Body} body @returns {Place[]} */
function ofBody(job, body) {
  const { shape, material } = job[body] ?? {};
  const [at, law] = [`/${body}`, lawOf(material)];
  const [ofShape, ofMaterial] = [`${at}/shape`, `${at}/material`];
  const tilts = { tilt: 'Tilt given', moment: 'Moment given' };
  return [
    choice(body, `${ofShape}/type`, 'Shape', shapesFor(job.analysis, shape?.type)),
    ...shapeFields(shape).flatMap((field) => [
      ...(field.key === tiltOf(shape)
        ? [choice(body, `${ofShape}/tilt_kind`, 'Misalignment', tilts)]
        : []),
      ...fields(body, ofShape, [field]),
    ]),
    ...ofSurface(job, body),
    // A half-space has no far boundary.
    ...(job.analysis === 'three_dimensional'
      ? []
      : [choice(body, `${at}/support`, 'Support', SUPPORTS)]),
    { part: body, place: 'shape' },
    { part: body, place: 'material' },
    ...fields(body, ofMaterial, [NAME, ...(law === 'rigid' ? [] : ELASTIC)]),
    choice(body, `${ofMaterial}/law`, 'Hardening', labels(LAWS)),
    ...fields(body, `${ofMaterial}/plasticity`, [
      ...(LAWS[law]?.fields ?? []).filter((field) => !isOverruled(material, field)),
      ...(LAWS[law]?.fields.length ? [BACKSTRESS] : []),
    ]),
    { part: body, place: 'curve' },
    ...ofDepth(job, body),
  ];
}

/** @param {Job} job @param {Body} body @returns {Place[]} */
function ofSurface(job, body) {
  const { analysis, [body]: of } = job;
  if (analysis !== 'three_dimensional' || of?.shape?.type === 'roller') return [];
  const kinds = { none: 'Smooth', given: 'Heights' };
  return [
    choice(body, `/${body}/surface_kind`, 'Surface', kinds),
    ...fields(body, `/${body}`, hasSurface(of) ? SURFACE : []),
  ];
}

/** @param {Job} job @param {Body} body @returns {Place[]} what varies over the depth of a body */
function ofDepth(job, body) {
  const material = job[body]?.material;
  const [law, at] = [lawOf(material), `/${body}/material`];
  const kinds = { none: 'None', given: 'Over depth' };
  const stress = hasInitialStress(material) ? [initialStressOf(job.analysis)] : [];
  return [
    ...(LAWS[law]?.fields.length ? ofOverDepth(body, at, material) : []),
    ...(law === 'rigid'
      ? []
      : [choice(body, `${at}/stress_kind`, 'Initial stress', kinds), ...fields(body, at, stress)]),
    { part: body, place: 'stress' },
  ];
}

/** @param {Part} part @param {string} at @param {any} material @returns {Place[]} */
function ofOverDepth(part, at, material) {
  const plasticity = `${at}/plasticity`;
  const kinds = { uniform: 'Uniform', ...labels(OVER_DEPTH) };
  const hint = 'Strength comes from the hardness; this law gives the shape of its curve.';
  const overruled = (LAWS[lawOf(material)]?.fields ?? [])
    .filter((field) => isOverruled(material, field))
    .map((field) => ({ ...field, hint }));
  return [
    choice(part, `${plasticity}/depth_kind`, 'Strength over depth', kinds),
    ...fields(part, plasticity, OVER_DEPTH[overDepthOf(material)]?.fields ?? []),
    ...fields(part, plasticity, overruled),
  ];
}

/** @param {Job} job @returns {Place[]} */
function ofLoad(job) {
  const kind = loadOf(job.load);
  const figures = {
    ...labels(TARGETS),
    ...(ratedApproach(job) && { [ISO_76.key]: ISO_76.label }),
  };
  // A dialogue asks for hardness tests; their members by name are beyond the form.
  const { hardness, ...usual } = labels(LOADS);
  const isTest = kind === 'hardness';
  return [
    choice('load', '/load/kind', 'Given', isTest ? { ...usual, hardness } : usual),
    ...fields('load', '/load', isTest && isObject(job.load.hardness) ? [] : LOADS[kind].fields),
    ...(kind === 'target'
      ? [
          choice('load', '/load/target_kind', 'Figure', figures),
          ...fields('load', '/load', [TARGETS[targetOf(job.load)]]),
        ]
      : []),
    choice('load', '/solver/theory', 'Theory', THEORIES),
  ];
}
