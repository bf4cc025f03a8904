/**
 * Figures of a step, each described once: for tiles, the table, curves over the load and the
 * report.
 */

import { forceOf, stiffnessOf, unit } from '../lib/units.js';

/** @typedef {import('../types.js').Step} Step */
/** @typedef {import('../types.js').Report} Report */
/**
 * @typedef {Exclude<keyof NonNullable<Step['estimated_error']>, 'bodies'>} Barred a figure of the
 *   contact whose error the mesh tells
 */
/**
 * @typedef {object} StepFigure
 * @property {string} title
 * @property {string} [short] in tables and at axes
 * @property {string} [round] title in axisymmetry
 * @property {string} [ellipse] title in three dimensions
 * @property {(report: Report) => string} unit
 * @property {(step: Step) => number | null | undefined} value
 * @property {Barred} [bar]
 */

/**
 * The bound of the error of a figure: none of what the job prescribes, and none of a state that is
 * not the answer.
 * @param {Step} step @param {Barred} name
 */
export const barOf = ({ status, estimated_error: bars }, name) =>
  (status === 'converged' && bars?.[name]) || undefined;

/** @param {import('../wire.js').RollingResult} rolling */
const rolledStrain = ({ passes }) => {
  const { upper, lower } = passes.at(-1)?.bodies ?? { upper: null, lower: null };
  return Math.max(upper?.accumulated_strain ?? 0, lower?.accumulated_strain ?? 0);
};

/**
 * Largest equivalent plastic strain of both bodies; none where one of them does not harden.
 * @param {Step} step
 */
export const strainOf = ({ plasticity: { upper, lower }, rolling }) =>
  rolling
    ? rolledStrain(rolling)
    : upper?.max_equivalent_plastic_strain === null ||
        lower?.max_equivalent_plastic_strain === null
      ? undefined
      : Math.max(
          upper?.max_equivalent_plastic_strain ?? 0,
          lower?.max_equivalent_plastic_strain ?? 0,
        );

const length = (/** @type {Report} */ { units }) => unit('length', units);
const stress = (/** @type {Report} */ { units }) => unit('stress', units);

/** In the order of the table. @satisfies {Record<string, StepFigure>} */
export const STEP_FIGURES = {
  force: {
    title: 'force',
    unit: (/** @type {Report} */ report) => unit(forceOf(report), report.units),
    value: (/** @type {Step} */ { contact }) => contact.force,
    bar: /** @type {const} */ ('force'),
  },
  approach: {
    title: 'approach',
    unit: length,
    value: (/** @type {Step} */ { approach }) => approach,
    bar: /** @type {const} */ ('approach'),
  },
  peak: {
    title: 'peak pressure',
    unit: stress,
    value: (/** @type {Step} */ { contact }) => contact.peak_pressure,
    bar: /** @type {const} */ ('peak_pressure'),
  },
  width: {
    title: 'half-width',
    round: 'contact radius',
    ellipse: 'shorter semi-axis',
    unit: length,
    value: (/** @type {Step} */ { contact }) => contact.half_width,
    bar: /** @type {const} */ ('half_width'),
  },
  mean: {
    title: 'mean pressure',
    unit: stress,
    value: (/** @type {Step} */ { contact }) => contact.mean_pressure,
  },
  strain: {
    title: 'plastic strain',
    unit: () => '%',
    value: (/** @type {Step} */ step) => {
      const strain = strainOf(step);
      return strain === undefined ? undefined : 100 * strain;
    },
  },
  stiffness: {
    title: 'contact stiffness',
    short: 'dP/dα',
    unit: (/** @type {Report} */ report) => unit(stiffnessOf(report), report.units),
    value: (/** @type {Step} */ { contact_stiffness: slope }) => slope ?? undefined,
    bar: /** @type {const} */ ('contact_stiffness'),
  },
  hertz: {
    title: 'Hertz peak',
    unit: stress,
    value: (/** @type {Step} */ { hertz }) => hertz?.peak_pressure,
  },
};

/** @param {StepFigure} figure @param {Report} report @returns {string} */
export const titleOf = ({ title, round, ellipse }, { analysis }) =>
  (analysis === 'axisymmetric' && round) || (analysis === 'three_dimensional' && ellipse) || title;
