/** A field for loads that follow each other: forces, and approaches behind an α. */

import { h } from '../lib/dom.js';
import { readQuantity } from '../lib/number.js';

/** @typedef {{force: number} | {approach: number}} HistoryLoad */

const APPROACH = /^[αa]=?(.+)$/i;

/** @param {unknown} history @returns {string} as it is typed */
export const writeHistory = (history) =>
  Array.isArray(history)
    ? history.map((load) => (load?.approach === undefined ? String(load?.force) : `α${load.approach}`)).join(' ')
    : String(history ?? '');

/**
 * @param {string} text
 * @param {import('../lib/units.js').Quantity} force
 * @param {import('../lib/units.js').Units} units
 * @returns {{loads: HistoryLoad[]} | {problem: string}}
 */
export function readHistory(text, force, units) {
  const loads = /** @type {HistoryLoad[]} */ ([]);
  for (const [k, part] of text
    .replace(/α\s+/g, 'α')
    .split(/[\s;→]+|,\s+/)
    .filter(Boolean)
    .entries()) {
    const far = APPROACH.exec(part)?.[1];
    const reading = readQuantity(far ?? part, far ? 'length' : force, units);
    if ('problem' in reading) return { problem: `load ${k + 1}: ${reading.problem}` };
    loads.push(far ? { approach: reading.value } : { force: reading.value });
  }
  return { loads };
}

/**
 * @param {import('./fields.js').Field} field
 * @param {string} id
 * @param {(value: unknown) => void} change
 * @param {import('./entry.js').Surroundings} surroundings
 * @returns {import('./entry.js').Control}
 */
export function historyControl(field, id, change, { units, quantity }) {
  const input = h('input', { id, type: 'text', autocomplete: 'off', spellcheck: 'false' });
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
    const longer = [...loads, ...more(loads)];
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
        button('and once more', (loads) => loads),
      ),
    ],
  };
}
