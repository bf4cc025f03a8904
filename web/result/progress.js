/** The progress of a running job in words. */

import { duration, figure } from '../lib/units.js';

/** @typedef {import('../types.js').Iteration} Iteration */

/**
 * Iterations are counted anew from 1 in every step of a sweep. The time left is that of the steps
 * that are done, times those that are not.
 * @param {Iteration[]} history of the job as far as it is
 * @param {import('../types.js').Job} [job] without it nothing is said of the step
 */
export function progressWords(history, job) {
  const last = history.at(-1);
  if (!last) return 'meshing and factorizing';
  const now = `iteration ${last.iteration}, out of balance ${figure(last.equilibrium_residual, 2)}`;
  const begins = history.filter(({ iteration }) => iteration === 1);
  const loads = job?.load?.forces ?? job?.load?.approaches;
  if (last.increment) {
    const { load, loads: all, number, count } = last.increment;
    return `${all > 1 ? `load ${load} of ${all}, ` : ''}increment ${number} of ${count}, ${now}`;
  }
  if (!Array.isArray(loads) || loads.length < 2) return now;
  const step = Math.min(begins.length, loads.length);
  return `step ${step} of ${loads.length}${left(begins, last, loads.length)}, ${now}`;
}

/**
 * @param {Iteration[]} begins of the steps so far
 * @param {Iteration} last
 * @param {number} total
 */
function left(begins, last, total) {
  const done = begins.length - 1;
  if (done < 1 || done >= total) return '';
  // The first step meshes and factorizes besides.
  const pace = (begins[done].elapsed_ms - begins[0].elapsed_ms) / done;
  const rest = pace * (total - done) - (last.elapsed_ms - begins[done].elapsed_ms);
  return rest > 1000
    ? `, about ${duration(1000 * Math.round(rest / 1000))
        .replace('.00', '')
        .replace('.0', '')} left`
    : '';
}
