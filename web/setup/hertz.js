/** Hertz's theory for the draft: its figures, or why it has none. */

import { Problem, post } from '../api/client.js';
import { shapeLabel } from './fields.js';

/** @typedef {{effective_radius: number, yield_onset_force: number | null, steps: {force: number, half_width: number, peak_pressure: number, yields: boolean}[]}} Hertz */
/** @typedef {{hertz: Hertz | null, why: string}} Answer `why` there are no figures, in words; empty where the draft is at fault */

/** Shapes without a curvature at the contact, which the theory is about. */
const WITHOUT = new Set(['profile', 'wedge', 'cone', 'punch']);
/** Shapes that curve away from nothing. */
const HOLLOW = new Set(['block', 'groove']);

/** @param {import('../types.js').Job} job @returns {string} why the theory does not apply, which the shapes tell */
function whyNot(job) {
  const shapes = [job.upper?.shape?.type, job.lower?.shape?.type];
  if (shapes.includes('hole'))
    return `one body lies within the other, and they touch over a wide arc`;
  const other = shapes.find((type) => WITHOUT.has(type));
  if (other)
    return `it takes round surfaces, and a ${shapeLabel(other, job.analysis).toLowerCase()} is none`;
  if (shapes.every((type) => HOLLOW.has(type))) return 'neither body is round at the contact';
  return '';
}

/**
 * Hertz for the job's forces; where it prescribes something else, for a unit of force, which still
 * tells the onset.
 * @param {import('../types.js').Job} job
 * @param {AbortSignal} signal
 * @returns {Promise<Answer>}
 * @throws {Problem} where the service does not answer
 */
export async function closedForm(job, signal) {
  const why = whyNot(job);
  if (why) return { hertz: null, why };
  /** @type {any[]} */
  const loads = Array.isArray(job.load?.history) ? job.load.history : [];
  // Of a history that prescribes approaches the highest force is not known.
  const highest = loads.every((load) => load?.approach === undefined)
    ? Math.max(0, ...loads.map((load) => Number(load?.force) || 0))
    : 0;
  const one = job.load?.rolling?.force ?? (highest > 0 ? highest : undefined);
  const forced = [one, job.load?.force, job.load?.forces].some((given) => given !== undefined);
  const load = one !== undefined ? { force: one } : forced ? job.load : { force: 1 };
  try {
    const answer = await post('v1/hertz', { ...job, load }, { signal });
    return { hertz: forced ? answer : { ...answer, steps: [] }, why: '' };
  } catch (error) {
    if (!(error instanceof Problem) || error.status !== 422) throw error;
    const shapes = error.errors.some(({ pointer }) => /^\/(upper|lower)\/shape$/.test(pointer));
    return {
      hertz: null,
      why: shapes
        ? 'it takes elastic surfaces that curve away from each other at the contact'
        : '',
    };
  }
}
