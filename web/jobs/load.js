/** What a job asks of its bodies, in words and with its unit. */

import { exact, forceOf, plain, unit, unitsOf } from '../lib/units.js';
import { TARGETS, loadOf, targetOf } from '../setup/fields.js';
import { historyWords } from '../setup/history.js';

/** @param {import('../types.js').Job} job @returns {string} */
export function loadWords(job) {
  const kind = loadOf(job.load);
  const value = job.load?.[kind];
  if (kind === 'onset') return 'onset of yield';
  if (kind === 'target') return `P for ${targetWords(job)}`;
  const far = kind.startsWith('approach');
  const name = unit(far ? 'length' : forceOf(job), unitsOf(job));
  const figures =
    kind === 'history'
      ? historyWords(value)
      : Array.isArray(value)
        ? `${plain(value[0])} … ${plain(value[value.length - 1])}`
        : exact(Number(value));
  return `${far ? 'α' : 'P'} ${figures} ${name}`;
}

/** @param {import('../types.js').Job} job */
function targetWords({ load, ...job }) {
  const figure = targetOf(load);
  const { label, quantity } = TARGETS[figure];
  const name = quantity && quantity !== 'load' ? unit(quantity, unitsOf(job)) : '';
  return `${label.toLowerCase()} ${exact(Number(load.target[figure]))} ${name}`.trim();
}
