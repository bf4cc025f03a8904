/** Several numbers in one field: separated by spaces, semicolons, arrows, or commas with a space; or a range. */

import { h } from '../lib/dom.js';
import { commas, groupsJoined, parted, quoted, readQuantity, withMinus } from '../lib/number.js';
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

/** @param {string} text @returns {{problem: string} | undefined} where it is more than numbers in a field are */
export const tooLong = (text) =>
  text.length > LONGEST
    ? { problem: `${quoted(text)} and so on is too long: at most ${MOST} numbers are taken` }
    : undefined;

/** Numbers between which nothing but spaces that do not break or are thin stands: one number in groups, or several as a document has them. */
const UNBROKEN =
  /^\s*[α\d.,+\-\u00a0\u2009\u202f]*\d{1,3}[\u00a0\u2009\u202f]\d{3}(?!\d)[\d.,\u00a0\u2009\u202f]*(?:\s*[^\d\s].*)?$/;

/** @param {string} text @returns {string[]} numbers as they are typed, each with the word behind it */
export function partsOf(text) {
  const plain = withMinus(text);
  if (UNBROKEN.test(plain)) return [plain.trim()];
  const parts = /** @type {string[]} */ ([]);
  for (const part of groupsJoined(plain)
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
  if (parts.length > MOST) return { problem: `${parts.length} ${name}s: at most ${MOST} are taken` };
  const shared = new Map();
  for (const quantity of new Set(parts.map((part) => part.quantity))) {
    const names = parts.filter((part) => part.quantity === quantity).map(({ text }) => parted(text).name);
    const last = names[names.length - 1];
    const each = names.slice(0, -1).some(Boolean);
    if (each && !names.every(Boolean))
      return { problem: 'write the unit behind each number, or behind the last one for all' };
    shared.set(quantity, !each && quantity && inJobUnits(1, last, quantity, units) ? last : '');
  }
  const values = [];
  const problems = [];
  const decimal = parts.some(({ text }) => commas(parted(text).digits) === 'decimal');
  for (const [k, { text, quantity }] of parts.entries()) {
    const problem = severalIn(text, parts.length === 1, parts[k - 1]?.text ?? '');
    const reading = problem
      ? { problem }
      : readQuantity(text, quantity, units, {
          unit: shared.get(quantity),
          meaning: decimal ? 'decimal' : undefined,
        });
    if ('problem' in reading)
      problems.push(parts.length > 1 ? `${name} ${k + 1}: ${reading.problem}` : reading.problem);
    else values.push(reading.value);
  }
  const [first, ...more] = problems;
  return first ? { problem: more.length ? `${first} (and ${more.length} more)` : first } : { values };
}

/**
 * What may be one number or several.
 * @param {string} text
 * @param {boolean} alone whether it is all there is
 * @param {string} before the number before it
 * @returns {string | undefined} what is not clear about it
 */
function severalIn(text, alone, before) {
  const { digits } = parted(text);
  if (/[\u00a0\u2009\u202f]/.test(digits))
    return `${quoted(digits)} can be one number or several: put plain spaces between numbers, and none within`;
  const commas = digits.match(/\d,(?=\d)/g)?.length ?? 0;
  if (commas > 1) return `${quoted(digits)} can be one number or several: put spaces between numbers`;
  if (commas === 1 && alone && !/^\D*0,/.test(digits) && !digits.includes('.')) {
    const [left, right] = digits.split(',');
    return `${quoted(digits)} can be one number or two: write ${left}.${right}, or ${left} ${right}`;
  }
  return /^[+-]?\d{1,3}$/.test(before) && /^0\d\d([.,]\d*)?$/.test(digits)
    ? `“${before} ${digits}” can be one number or two: write ${before}${digits} without a space`
    : undefined;
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
  const long = tooLong(text);
  if (long) return long;
  if (!/…|\.\./.test(text)) return read(partsOf(text));
  const [, from, to, count] = /^\s*(.+?)\s*(?:…|\.{2,3})\s*(.+?)\s*\/\s*(\d+)\s*$/.exec(text) ?? [];
  if (!count) return { problem: 'a range is written as 100…1200/12: from, to, how many' };
  const many = Number(count);
  if (many < 2 || many > MOST) return { problem: `a range has 2 to ${MOST} numbers, not ${count}` };
  const ends = read([from, to].map(groupsJoined));
  if ('problem' in ends) return ends;
  const [first, last] = ends.values;
  const step = (last - first) / (many - 1);
  return { values: Array.from({ length: many }, (_, k) => Number((first + step * k).toPrecision(8))) };
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

/** @param {import('./fields.js').Field} field @param {string} id @param {import('./entry.js').Surroundings} surroundings @returns {import('./entry.js').Control} */
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
