/** Meshes that are refined until error bars are small enough, and how long that takes. */

import { numberOf } from '../lib/number.js';
import { same } from '../lib/pointer.js';
import { duration } from '../lib/units.js';
import { usualElements } from './fields.js';

/** @typedef {import('../types.js').Job} Job */
/** @typedef {import('../types.js').Report} Report */
/** @typedef {{job: Job, report: Report}} Solved */

/** Meshes that the service solves in turn: their elements over those of the job. */
const MESHES = [1, 1.5, 2.25, 3.375, 4];

/** Exponent of the time of a mesh over its elements. @param {Job} job */
const exponent = ({ analysis }) => (analysis === 'three_dimensional' ? 2.8 : 2.3);

/** The mesh of a job that is not refined. @param {Job} job */
export const oneMesh = ({ mesh }) => mesh && { ...mesh, accuracy: undefined };

/** @param {Job} job */
const elements = (job) => numberOf(job.mesh?.elements_per_half_width ?? usualElements(job));

/** What makes the figures but the mesh. @param {Job} job */
const apart = ({ mesh: _, title: __, tags: ___, ...job }) => job;

/**
 * How long a job takes on meshes that are refined to an accuracy, told from the same job on one
 * mesh: its time, and its largest error bar, which falls with the size of the elements.
 * @param {number} asked
 * @param {Job} job
 * @param {Solved | undefined} solved
 * @returns {string} nothing where no such job is solved
 */
export function timeWords(asked, job, solved) {
  if (!solved || !same(apart(job), apart(solved.job))) return '';
  const { steps, answers = [], timings_ms: timings } = solved.report;
  const bars = [...answers, ...steps.flatMap((step) => step.answers)].map(({ detail, error }) =>
    detail ? 0 : numberOf(error) || 0,
  );
  const finer = MESHES.map((times) => (times * elements(job)) / elements(solved.job));
  const enough = finer.findIndex((times) => Math.max(0, ...bars) <= asked * times);
  const time = finer
    .slice(0, enough < 0 ? undefined : enough + 1)
    .reduce((sum, times) => sum + timings.total * times ** exponent(job), 0);
  return time > 0 ? `${enough < 0 ? 'at most' : 'about'} ${duration(time, 2)}` : '';
}
