/**
 * Several numbers in one field: separated by spaces, semicolons, arrows, or commas with a space;
 * or a range.
 */

import { h } from '../lib/dom.js';
import { hasDecimalComma, parted, quoted, readQuantity, withMinus } from '../lib/number.js';
import { exact, inJobUnits } from '../lib/units.js';
import { written } from './written.js';

/** @typedef {import('../lib/units.js').Quantity} Quantity */
/** @typedef {import('../lib/units.js').Units} Units */
/** @typedef {{text: string, quantity: Quantity | undefined}} Part one number, a unit behind it */
/** @typedef {{values: number[]} | {problem: string}} Readings */

/** Most numbers that the service takes. */
const MOST = 1000;
/** Most letters of a text that may be as many. */
export const LONGEST = 50_000;

/**
 * Digits that may belong together or not: groups of three with a space or an apostrophe, and
 * commas with nothing else between numbers.
 */
const UNCLEAR = /\d(?:[\u00a0\u2009\u202f'’]\d{3}|\s+0\d\d)(?!\d)|^\D*[1-9]\d*(?:,\d+)+\D*$/;

/** @param {string} text @returns {{problem: string} | undefined} why it is not clear which numbers it has */
export function unclear(text) {
  if (text.length > LONGEST)
    return { problem: `${quoted(text)} and so on is too long: at most ${MOST} numbers are taken` };
  return UNCLEAR.test(text)
    ? {
        problem: `${quoted(text)} can be one number or several: put a space between numbers, none within, and a point for decimals`,
      }
    : undefined;
}

/** @param {string} text @returns {string[]} numbers as they are typed, each with the word behind it */
export function partsOf(text) {
  const parts = /** @type {string[]} */ ([]);
  for (const part of withMinus(text)
    .replace(/α\s+/g, 'α')
    .replace(/[-=]>/g, '→')
    .split(/\s*[;→]\s*|\s*,\s+|\s+,\s*|\s+/)
    .filter(Boolean)) {
    const isUnit = !/^([αa]=?)?[+\-.,]*\d/i.test(part);
    if (isUnit && parts.length) parts[parts.length - 1] += ` ${part}`;
    else parts.push(part);
  }
  return parts;
}

/**
 * Reads each of the parts; the unit behind the last one of a quantity is that of all of them.
 * @param {Part[]} parts
 * @param {Units} units of the job
 * @param {string} name of a part in messages
 * @returns {Readings}
 */
export function readParts(parts, units, name = 'number') {
  if (parts.length > MOST)
    return { problem: `${parts.length} ${name}s: at most ${MOST} are taken` };
  const shared = new Map();
  for (const quantity of new Set(parts.map((part) => part.quantity))) {
    const names = parts
      .filter((part) => part.quantity === quantity)
      .map(({ text }) => parted(text).name);
    const last = names[names.length - 1];
    const each = names.slice(0, -1).some(Boolean);
    if (each && !names.every(Boolean))
      return { problem: 'write the unit behind each number, or behind the last one for all' };
    shared.set(quantity, !each && quantity && inJobUnits(1, last, quantity, units) ? last : '');
  }
  const commas = parts.some(({ text }) => hasDecimalComma(parted(text).digits));
  const values = [];
  const problems = [];
  for (const [k, { text, quantity }] of parts.entries()) {
    const reading = readQuantity(text, quantity, units, { unit: shared.get(quantity), commas });
    if ('problem' in reading)
      problems.push(parts.length > 1 ? `${name} ${k + 1}: ${reading.problem}` : reading.problem);
    else values.push(reading.value);
  }
  const [first, ...more] = problems;
  return first
    ? { problem: more.length ? `${first} (and ${more.length} more)` : first }
    : { values };
}

/**
 * @param {string} text numbers, or `first…last/count`
 * @param {Quantity | undefined} quantity
 * @param {Units} units of the job
 * @returns {Readings}
 */
export function readList(text, quantity, units) {
  const read = (/** @type {string[]} */ parts) =>
    readParts(
      parts.map((part) => ({ text: part, quantity })),
      units,
    );
  const refused = unclear(text);
  if (refused) return refused;
  if (!/…|\.\./.test(text)) return read(partsOf(text));
  const [, from, to, count] =
    /^\s*(.+?)\s*(?:…|\.{2,3})\s*(.+?)\s*\/\s*(\d+)\s*$/.exec(text) ?? [];
  if (!count) return { problem: 'a range is written as 100…1200/12: from, to, how many' };
  const many = Number(count);
  if (many < 2 || many > MOST)
    return { problem: `a range has 2 to ${MOST} numbers, not ${count}` };
  const ends = read([from, to]);
  if ('problem' in ends) return ends;
  const [first, last] = ends.values;
  const step = (last - first) / (many - 1);
  return {
    values: Array.from({ length: many }, (_, k) => Number((first + step * k).toPrecision(8))),
  };
}

/** Numbers that are written out where there is little room. */
const FEW = 4;

/** A list where there is little room: from the first to the last number, where it rises or falls all the way. @param {number[]} values */
export function sweepWords(values) {
  const ways = new Set(values.slice(1).map((value, k) => Math.sign(value - values[k])));
  const ends = (/** @type {number[]} */ list) => [...new Set(list.map(exact))].join(' … ');
  if (ways.size < 2) return ends([values[0], values[values.length - 1]]);
  return values.length <= FEW
    ? values.map(exact).join(', ')
    : `${values.length} values, ${ends([Math.min(...values), Math.max(...values)])}`;
}

/** @param {import('./field.js').Field} field @param {string} id @param {import('./field.js').Surroundings} surroundings @returns {import('./field.js').Control} */
export function listControl(field, id, { units, quantity }) {
  const input = h('input', {
    id,
    type: 'text',
    maxlength: LONGEST + 1,
    inputmode: 'text',
    autocomplete: 'off',
    spellcheck: 'false',
  });
  const reading = (/** @type {string} */ text) => readList(text, quantity(field), units());
  return {
    input,
    // What is at fault stays in the draft as it is typed, and is refused there.
    read: () => {
      const result = reading(input.value);
      return 'values' in result ? result.values : input.value;
    },
    write: (value) => {
      input.value = Array.isArray(value) ? value.map(written).join(' ') : written(value);
    },
    problem: (value) => {
      const result = typeof value === 'string' ? reading(value) : undefined;
      return result && 'problem' in result ? result.problem : '';
    },
  };
}
