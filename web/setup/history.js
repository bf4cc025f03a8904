/** A field for loads that follow each other: forces, and approaches behind an α. */

import { h } from '../lib/dom.js';
import { numberOf } from '../lib/number.js';
import { same } from '../lib/pointer.js';
import { plain } from '../lib/units.js';
import { LONGEST, partsOf, readParts, tooLong } from './list.js';
import { written } from './written.js';

/** @typedef {{force: number} | {approach: number}} HistoryLoad */

/** Most loads that the service takes. */
const MOST = 1000;

const APPROACH = /^[αa]=?(.+)$/i;

/** @param {unknown} history @returns {string} as it is typed */
export const writeHistory = (history) =>
  Array.isArray(history)
    ? history
        .map((load) =>
          load?.force !== undefined
            ? String(load.force)
            : load?.approach !== undefined
              ? `α${load.approach}`
              : JSON.stringify(load),
        )
        .join(' ')
    : written(history);

/** Loads that are written out where there is little room. */
const FEW = 4;

/** @param {unknown} history @param {number} [most] loads that are written out @param {(value: number) => string} [write] @returns {string} as it is read */
export function historyWords(history, most = FEW, write = plain) {
  if (!Array.isArray(history)) return writeHistory(history);
  const load = (/** @type {any} */ one) =>
    one?.approach === undefined ? write(numberOf(one?.force)) : `α ${write(numberOf(one.approach))}`;
  if (history.length <= most) return history.map(load).join(' → ');
  const forces = history.map((one) => numberOf(one?.force)).filter(Number.isFinite);
  return `${history.length} loads${forces.length ? ` up to ${plain(Math.max(...forces))}` : ''}`;
}

/**
 * @param {string} text
 * @param {import('../lib/units.js').Quantity} force
 * @param {import('../lib/units.js').Units} units
 * @returns {{loads: HistoryLoad[]} | {problem: string}}
 */
export function readHistory(text, force, units) {
  const long = tooLong(text);
  if (long) return long;
  const parts = partsOf(text).map((part) => {
    const far = APPROACH.exec(part)?.[1];
    return far
      ? { text: far, quantity: /** @type {const} */ ('length'), key: 'approach' }
      : { text: part, quantity: force, key: 'force' };
  });
  const readings = readParts(parts, units, 'load');
  if ('problem' in readings) return readings;
  return { loads: parts.map(({ key }, k) => /** @type {HistoryLoad} */ ({ [key]: readings.values[k] })) };
}

/** The loads that are repeated: the fewest from which all of them come. @param {HistoryLoad[]} loads */
function cycleOf(loads) {
  const repeats = (/** @type {number} */ period) => loads.every((load, k) => same(load, loads[k % period]));
  const period = loads.findIndex((_, k) => k > 0 && loads.length % k === 0 && repeats(k));
  return period < 0 ? loads : loads.slice(0, period);
}

/**
 * @param {import('./fields.js').Field} field
 * @param {string} id
 * @param {(value: unknown) => void} change
 * @param {import('./entry.js').Surroundings} surroundings
 * @returns {import('./entry.js').Control}
 */
export function historyControl(field, id, change, { units, quantity }) {
  const input = h('input', { id, type: 'text', maxlength: LONGEST + 1, autocomplete: 'off', spellcheck: 'false' });
  const reading = (/** @type {string} */ text) => readHistory(text, quantity(field) ?? 'force', units());
  const read = () => {
    const result = reading(input.value);
    return 'loads' in result ? result.loads : input.value;
  };
  const write = (/** @type {any} */ value) => {
    input.value = writeHistory(value);
  };
  const append = (/** @type {(loads: HistoryLoad[]) => HistoryLoad[]} */ more) => {
    const loads = read();
    if (!Array.isArray(loads)) return;
    const longer = [...loads, ...more(loads)].slice(0, MOST);
    write(longer);
    change(longer);
  };
  const button = (/** @type {string} */ text, /** @type {(loads: HistoryLoad[]) => HistoryLoad[]} */ more) =>
    h('button', { type: 'button', class: 'plain', onclick: () => append(more) }, text);
  return {
    input,
    read,
    write,
    problem: (value) => {
      const result = typeof value === 'string' ? reading(value) : undefined;
      return result && 'problem' in result ? result.problem : '';
    },
    beside: [
      h(
        'div',
        { class: 'bar beside' },
        button('and back to 0', () => [{ force: 0 }]),
        button('and once more', cycleOf),
      ),
    ],
  };
}
