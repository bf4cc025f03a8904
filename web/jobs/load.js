/** What a job asks of its bodies, in words and with its unit. */

import { exact, forceOf, unit, unitsOf } from '../lib/units.js';
import { TARGETS, loadOf, targetOf } from '../setup/fields.js';
import { historyWords } from '../setup/history.js';
import { rollingWords } from '../setup/load-line.js';
import { sweepWords } from '../setup/list.js';

/** @param {import('../types.js').Job} job @returns {string} */
export function loadWords(job) {
  const kind = loadOf(job.load);
  const value = job.load?.[kind];
  if (kind === 'onset') return 'onset of yield';
  if (kind === 'target') return `P for ${targetWords(job)}`;
  const [force, approach] = [unit(forceOf(job), unitsOf(job)), unit('length', unitsOf(job))];
  if (kind === 'rolling') return `P ${rollingWords(value, force)}`;
  if (kind === 'history') return historyWords(value, { force, approach });
  const [letter, name] = kind.startsWith('approach') ? ['α', approach] : ['P', force];
  return `${letter} ${Array.isArray(value) ? sweepWords(value) : exact(Number(value))} ${name}`;
}

/** @param {import('../types.js').Job} job */
function targetWords({ load, ...job }) {
  const figure = targetOf(load);
  const { label, quantity } = TARGETS[figure];
  const name = quantity && quantity !== 'load' ? unit(quantity, unitsOf(job)) : '';
  return `${label.toLowerCase()} ${exact(Number(load.target[figure]))} ${name}`.trim();
}
