/**
 * Which loads a job asked for and which of them are solved, and which steps of compared jobs
 * belong beside each other.
 */

import { figure, forceOf, unit } from '../lib/units.js';
import { forceIn, hasYielded } from './rows.js';

/** @typedef {import('../shown.js').Shown} Shown */
/** @typedef {import('../types.js').Report} Report */
/** @typedef {import('../types.js').Job} Job */
/**
 * @typedef {{one: Shown, at: number, label: string}} Beside a job, its step that is laid beside
 *   the one shown, and the name of both
 */

/** Forces that differ by less are the same load. */
const SAME = 1e-3;

/** How many loads a job asks for. @param {Job} job @returns {number} */
export function asked({ load }) {
  const loads = load?.forces ?? load?.approaches ?? load?.history;
  return Array.isArray(loads) ? loads.length : 1;
}

/**
 * How many loads are solved, and which steps are no answers.
 * @param {Job} job
 * @param {Report} report
 * @returns {string}
 */
export function solvedWords(job, { steps }) {
  const failed = steps.flatMap(({ status }, k) => (status === 'converged' ? [] : [k + 1]));
  const many = Math.max(steps.length, asked(job));
  const not =
    failed.length === 0
      ? ''
      : failed.length === 1
        ? `; step ${failed[0]} is not an answer`
        : `; ${failed.length} steps did not converge and are not answers`;
  return `${steps.length - failed.length} of ${many} loads are solved${not}`;
}

/**
 * What is to be said of a job that ended before its last load.
 * @param {Job} job
 * @param {Report} report
 * @returns {string} nothing where it came to its end
 */
export const endedEarly = (job, report) =>
  report.steps.length < asked(job)
    ? `The job ended before its last load: ${solvedWords(job, report)}.`
    : '';

/** Whether the stresses over depth are those that a load has left. @param {import('../types.js').Step} step */
export const isResidual = (step) => isUnloaded(step) || step.passes !== undefined;

/** Whether the load is taken away. @param {import('../types.js').Step} step */
export const isUnloaded = (step) => forceIn(step) === 0 && step.surfaces !== undefined;

/** Load of a step with its unit. @param {Report} report @param {number} at */
export const loadWords = (report, at) =>
  `${figure(forceIn(report.steps[at]), 4)} ${unit(forceOf(report), report.units)}`;

/**
 * Whether a load before this one, at least as large, has dented the bodies: Hertz's theory tells
 * of bodies without a dent.
 * @param {Report} report @param {number} at
 */
export const isDented = ({ steps }, at) =>
  steps.slice(0, at).some((step) => forceIn(step) >= forceIn(steps[at]) && hasYielded(step));

/** What figures by Hertz's theory are of. @param {Report} report @param {number} at */
export const hertzName = (report, at) =>
  isDented(report, at) ? 'Hertz, undented bodies' : 'Hertz, elastic';

/**
 * The step of every job that is laid beside a step of the first: that under the same force, or
 * else that of the same number, or else the last one. Where there are several to choose from, the
 * label says which it is.
 * @param {Shown[]} shown @param {number} at step of the first
 * @returns {Beside[]}
 */
export function beside(shown, at) {
  const force = forceIn(shown[0].report.steps[at]);
  const several = shown.some(({ report }) => report.steps.length > 1);
  return shown.map((one, k) => {
    const { steps } = one.report;
    const forces = steps.map(forceIn);
    const alike = (/** @type {number} */ other) =>
      Math.abs(other - force) <= SAME * Math.max(Math.abs(force), Math.abs(other));
    const found = alike(forces[at]) ? at : forces.findIndex(alike);
    const step = k === 0 ? at : found >= 0 ? found : Math.min(at, steps.length - 1);
    const which = steps.length > 1 ? `, step ${step + 1} of ${steps.length}` : '';
    return {
      one,
      at: step,
      label: several ? `${one.label}${which}, ${loadWords(one.report, step)}` : one.label,
    };
  });
}
