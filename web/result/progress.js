/** The progress of a running job in words, and as a part of the whole. */

import { duration } from '../lib/units.js';

/** @typedef {import('../types.js').Iteration} Iteration */
/** @typedef {import('../types.js').Job} Job */

/** Part of the work, and time [ms], before which the time left is a guess. */
const [TOLD, BEGUN] = [0.05, 1000];

/**
 * Which pass, load or iteration it is, and about how long it takes from there.
 * @param {Iteration[]} history of the job as far as it is
 * @param {Job} job
 * @returns {{words: string, part: number}} `part`: of the work that is done
 */
export function progressOf(history, job) {
  const last = history.at(-1);
  if (!last) return { words: 'meshing and factorizing', part: 0 };
  const { at, all, within } = last.increment ? ofIncrement(last.increment) : ofStep(history, job);
  const part = (at - 1 + within) / all;
  // Meshing and the first factorization are done once.
  const rest = ((last.elapsed_ms - history[0].elapsed_ms) * (1 - part)) / part;
  const kind = job.load?.rolling ? 'pass' : 'load';
  const words = [
    all > 1 ? `${kind} ${at} of ${all}` : `iteration ${last.iteration}`,
    // How many meshes an accuracy takes is not known.
    !job.mesh?.accuracy && part > TOLD && rest > BEGUN && `about ${rounded(rest)} left`,
  ];
  return { words: words.filter(Boolean).join(', '), part };
}

/** @param {NonNullable<Iteration['increment']>} increment */
const ofIncrement = ({ load, loads, number, count }) => ({
  at: load,
  all: loads,
  within: (number - 1) / count,
});

/**
 * Iterations are counted anew from 1 in every step of a sweep; each of them comes nearer to balance
 * by about the same factor.
 * @param {Iteration[]} history @param {Job} job
 */
function ofStep(history, job) {
  const loads = job.load?.forces ?? job.load?.approaches;
  const begins = history.findLastIndex(({ iteration }) => iteration === 1);
  const steps = history.filter(({ iteration }) => iteration === 1).length;
  const all = Array.isArray(loads) ? loads.length : 1;
  const decades = (/** @type {number} */ residual) =>
    Math.log10(history[Math.max(0, begins)].equilibrium_residual / residual);
  const whole = decades(Number(job.solver?.tolerance ?? 1e-6));
  const done = decades(history[history.length - 1].equilibrium_residual);
  const within = whole > 0 ? Math.min(1, Math.max(0, done / whole)) : 0;
  return { at: Math.min(Math.max(1, steps), all), all, within };
}

/** @param {number} ms */
const rounded = (ms) =>
  duration(1000 * Math.round(ms / 1000))
    .replace('.00', '')
    .replace('.0', '');
