/** Numbers as people write them: decimal points and commas, grouped thousands, a unit behind. */

import { inJobUnits } from './units.js';

/** @typedef {import('./units.js').Quantity} Quantity */
/** @typedef {import('./units.js').Units} Units */
/** @typedef {{value: number} | {problem: string}} Reading */

const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;
/** One comma and three digits behind it: a decimal comma or a thousand. */
const AMBIGUOUS = /^[+-]?[1-9]\d{0,2},\d{3}$/;
const DECIMAL_COMMA = /^[+-]?\d*,\d+(e[+-]?\d+)?$/i;
const COMMA_THOUSANDS = /^[+-]?\d{1,3}(,\d{3})+(\.\d*)?(e[+-]?\d+)?$/i;
const POINT_THOUSANDS = /^[+-]?\d{1,3}(\.\d{3})+,\d*(e[+-]?\d+)?$/i;

/** What commas stand for in a text: `null` if they may be either. @param {string} text @returns {'decimal' | 'thousands' | null | undefined} */
export function commas(text) {
  const plain = tidy(text);
  if (!plain.includes(',')) return undefined;
  if (AMBIGUOUS.test(plain)) return null;
  if (DECIMAL_COMMA.test(plain) || POINT_THOUSANDS.test(plain)) return 'decimal';
  return COMMA_THOUSANDS.test(plain) ? 'thousands' : undefined;
}

/**
 * @param {string} text
 * @param {'decimal' | 'thousands'} [meaning] of commas, where it is known
 * @returns {Reading}
 */
export function readNumber(text, meaning) {
  const plain = tidy(text);
  if (NUMBER.test(plain)) return { value: Number(plain) };
  const means = meaning ?? commas(plain);
  if (means === null) {
    const [whole, part] = plain.split(',');
    return { problem: `“${text.trim()}” can be read as ${whole}.${part} or as ${whole}${part}: write one of these` };
  }
  const converted =
    means === 'decimal' ? plain.replaceAll('.', '').replace(',', '.') : means ? plain.replaceAll(',', '') : '';
  if (NUMBER.test(converted)) return { value: Number(converted) };
  return { problem: `“${text.trim()}” is not a number` };
}

/**
 * A number with or without a unit, in the units of the job.
 * @param {string} text
 * @param {Quantity | undefined} quantity
 * @param {Units} units
 * @returns {Reading}
 */
export function readQuantity(text, quantity, units) {
  const [, digits, name] = /^\s*([+\-−]?[\d.,\s]*\d[.,]?(?:e[+-]?\d+)?)\s*([^\d\s].*?)?\s*$/i.exec(text) ?? [];
  if (!name || !quantity) return readNumber(text);
  const reading = readNumber(digits);
  if ('problem' in reading) return reading;
  const value = inJobUnits(reading.value, name, quantity, units);
  return value === undefined ? { problem: `“${name}” is no unit known here for this figure` } : { value };
}

/** Without spaces that group digits, with a plain minus. @param {string} text */
const tidy = (text) =>
  text
    .trim()
    .replace(/[−–]/g, '-')
    .replace(/(?<=\d)[\s\u00a0\u202f'’](?=\d{3}(?!\d))/g, '');
