/** A field for loads that follow each other: forces, and approaches behind an α. */

import { h, plainButton } from '../lib/dom.js';
import { numberOf } from '../lib/number.js';
import { same } from '../lib/pointer.js';
import { exact } from '../lib/units.js';
import { LONGEST, partsOf, readParts, unclear } from './list.js';
import { written } from './written.js';

/** @typedef {{force: number} | {approach: number}} HistoryLoad */

/** Most loads that the service takes. */
const MOST = 1000;

const APPROACH = /^[αa]=?(.+)$/i;

/** @param {unknown} history @returns {string} as it is typed */
const writeHistory = (history) =>
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

/** @typedef {{force: string, approach: string}} LoadUnits */

/** @param {any} load */
const kindOf = (load) => (load?.approach === undefined ? 'force' : 'approach');

/** @param {any} load */
const figureOf = (load) => numberOf(load?.[kindOf(load)]);

/** Every load with nothing but its figure, approaches behind an α. @param {any[]} history */
export const historyFigures = (history) =>
  history
    .map((load) => `${kindOf(load) === 'force' ? '' : 'α '}${exact(figureOf(load))}`)
    .join(' → ');

/**
 * Loads in turn with letters and units, where there is little room: those of one kind that follow
 * each other share them; of many, what is prescribed at most.
 * @param {unknown} history
 * @param {LoadUnits} units
 * @param {{few?: number, is?: string}} [written] loads that are written out; what stands behind a letter
 * @returns {string}
 */
export function historyWords(history, units, { few = FEW, is = ' ' } = {}) {
  const kinds = /** @type {const} */ ([
    { kind: 'force', letter: 'P' },
    { kind: 'approach', letter: 'α' },
  ]);
  if (!Array.isArray(history)) return `P${is}${writeHistory(history)} ${units.force}`;
  const of = (/** @type {any} */ load) => kinds[kindOf(load) === 'force' ? 0 : 1];
  if (history.length > few) {
    const parts = kinds.flatMap(({ kind, letter }) => {
      const figures = history.filter((load) => kindOf(load) === kind).map(figureOf);
      return figures.length
        ? [{ letter, most: `up to ${exact(Math.max(...figures))} ${units[kind]}` }]
        : [];
    });
    const count = `${history.length} loads`;
    return parts.length === 1
      ? `${parts[0].letter}${is}${count} ${parts[0].most}`
      : [count, ...parts.map(({ letter, most }) => `${letter} ${most}`)].join(', ');
  }
  return history
    .map((load, k) => {
      const { kind, letter } = of(load);
      const [begins, ends] = [history[k - 1], history[k + 1]].map(
        (next) => !next || kindOf(next) !== kind,
      );
      return `${begins ? letter + is : ''}${exact(figureOf(load))}${ends ? ` ${units[kind]}` : ''}`;
    })
    .join(' → ');
}

/**
 * @param {string} text
 * @param {import('../lib/units.js').Quantity} force
 * @param {import('../lib/units.js').Units} units
 * @returns {{loads: HistoryLoad[]} | {problem: string}}
 */
export function readHistory(text, force, units) {
  const refused = unclear(text);
  if (refused) return refused;
  const parts = partsOf(text).map((part) => {
    const far = APPROACH.exec(part)?.[1];
    return far
      ? { text: far, quantity: /** @type {const} */ ('length'), key: 'approach' }
      : { text: part, quantity: force, key: 'force' };
  });
  const readings = readParts(parts, units, 'load');
  if ('problem' in readings) return readings;
  return {
    loads: parts.map(({ key }, k) => /** @type {HistoryLoad} */ ({ [key]: readings.values[k] })),
  };
}

/** The loads that are repeated: the fewest from which all of them come. @param {HistoryLoad[]} loads */
function cycleOf(loads) {
  const repeats = (/** @type {number} */ period) =>
    loads.every((load, k) => same(load, loads[k % period]));
  const period = loads.findIndex((_, k) => k > 0 && loads.length % k === 0 && repeats(k));
  return period < 0 ? loads : loads.slice(0, period);
}

/**
 * @param {import('./field.js').Field} field
 * @param {string} id
 * @param {(value: unknown) => void} change
 * @param {import('./field.js').Surroundings} surroundings
 * @returns {import('./field.js').Control}
 */
export function historyControl(field, id, change, { units, quantity }) {
  const input = h('input', {
    id,
    type: 'text',
    maxlength: LONGEST + 1,
    autocomplete: 'off',
    spellcheck: 'false',
  });
  const reading = (/** @type {string} */ text) =>
    readHistory(text, quantity(field) ?? 'force', units());
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
  const button = (
    /** @type {string} */ text,
    /** @type {(loads: HistoryLoad[]) => HistoryLoad[]} */ more,
  ) => plainButton(text, () => append(more));
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
