/**
 * Figures of a step, each described once: for tiles, the table, curves over the load and the
 * report.
 */

import { forceOf, stiffnessOf, unit } from '../lib/units.js';

/** @typedef {import('../types.js').Step} Step */
/** @typedef {import('../types.js').Report} Report */
/**
 * @typedef {object} StepFigure
 * @property {string} title
 * @property {string} [short] in tables and at axes
 * @property {string} [round] title in axisymmetry
 * @property {string} [ellipse] title in three dimensions
 * @property {(report: Report) => string} unit
 * @property {(step: Step) => number | null | undefined} value
 * @property {string} [answer] its name among the answers; without one it follows from what is given
 */

/** The answer that a figure is. @param {Step} step @param {StepFigure} figure */
const answerOf = ({ answers = [] }, { answer }) => answers.find(({ name }) => name === answer);

/** What a step says of a figure. @param {Step} step @param {StepFigure} figure @returns {number | null} nothing where its answer has no value */
export const valueOf = (step, figure) =>
  answerOf(step, figure)?.value === null ? null : (figure.value(step) ?? null);

/**
 * The bound of the error of a figure, as its answer has it, or the mesh in results of 0.2.
 * @param {Step} step @param {StepFigure} figure
 * @returns {number | null | undefined} 0 of what is given, nothing where it is not known
 */
export function errorOf(step, figure) {
  const { answer } = figure;
  if (!answer) return 0;
  if (step.status !== 'converged') return null;
  const found = answerOf(step, figure);
  return found ? found.error : /** @type {any} */ (step.estimated_error)?.[answer];
}

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
    answer: 'force',
  },
  approach: {
    title: 'approach',
    unit: length,
    value: (/** @type {Step} */ { approach }) => approach,
    answer: 'approach',
  },
  peak: {
    title: 'peak pressure',
    unit: stress,
    value: (/** @type {Step} */ { contact }) => contact.peak_pressure,
    answer: 'peak_pressure',
  },
  width: {
    title: 'half-width',
    round: 'contact radius',
    ellipse: 'shorter semi-axis',
    unit: length,
    value: (/** @type {Step} */ { contact }) => contact.half_width,
    answer: 'half_width',
  },
  mean: {
    title: 'mean pressure',
    unit: stress,
    value: (/** @type {Step} */ { contact }) => contact.mean_pressure,
    answer: 'mean_pressure',
  },
  strain: {
    title: 'plastic strain',
    unit: () => '%',
    value: (/** @type {Step} */ step) => {
      const strain = strainOf(step);
      return strain === undefined ? undefined : 100 * strain;
    },
    answer: 'max_plastic_strain',
  },
  stiffness: {
    title: 'contact stiffness',
    short: 'dP/dα',
    unit: (/** @type {Report} */ report) => unit(stiffnessOf(report), report.units),
    value: (/** @type {Step} */ { contact_stiffness: slope }) => slope ?? undefined,
    answer: 'contact_stiffness',
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
