/** Numbers as people write them: decimal points and commas, grouped thousands, a unit behind. */

import { inJobUnits } from './units.js';

/** @typedef {import('./units.js').Quantity} Quantity */
/** @typedef {import('./units.js').Units} Units */
/** @typedef {{value: number} | {problem: string}} Reading */

const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;
/** One comma and three digits behind it: a decimal comma or a thousand. */
const AMBIGUOUS = /^[+-]?[1-9]\d{0,2},\d{3}$/;
/** The same of a point among decimal commas. */
const AMBIGUOUS_POINT = /^[+-]?[1-9]\d{0,2}\.\d{3}$/;
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
  if (text.length > LONGEST) return { problem: `${quoted(text)} is not a number` };
  const plain = tidy(text);
  if (meaning === 'decimal' && AMBIGUOUS_POINT.test(plain)) {
    const [whole, part] = plain.split('.');
    return {
      problem: `${quoted(text)} can be read as ${whole},${part} or as ${whole}${part}, where commas are decimal: write one of these`,
    };
  }
  if (NUMBER.test(plain)) return valueOf(plain, text);
  const means = meaning ?? commas(plain);
  if (means === null) {
    const [whole, part] = plain.split(',');
    return { problem: `${quoted(text)} can be read as ${whole}.${part} or as ${whole}${part}: write one of these` };
  }
  const converted =
    means === 'decimal' ? plain.replaceAll('.', '').replace(',', '.') : means ? plain.replaceAll(',', '') : '';
  if (NUMBER.test(converted)) return valueOf(converted, text);
  return { problem: `${quoted(text)} is not a number` };
}

/** @param {string} plain @param {string} text as it was typed @returns {Reading} */
function valueOf(plain, text) {
  const value = Number(plain);
  if (!Number.isFinite(value)) return { problem: `${quoted(text)} is too large for a number` };
  const vanishes = value === 0 && /[1-9]/.test(plain.replace(/e.*/i, ''));
  return vanishes ? { problem: `${quoted(text)} is too close to 0 for a number` } : { value };
}

/** What stands before the unit, and the unit, where there is one. @param {string} text @returns {{digits: string, name: string}} */
export function parted(text) {
  const plain = withExponents(text);
  const [, digits = plain.trim(), name = ''] =
    /^\s*([+-]?[\d.,\s'’]*\d[.,]?(?:e[+-]?\d+)?)\s*([^\d\s].*?)?\s*$/i.exec(plain) ?? [];
  return { digits, name };
}

/**
 * A number with or without a unit, in the units of the job.
 * @param {string} text
 * @param {Quantity | undefined} quantity
 * @param {Units} units
 * @param {{unit?: string, meaning?: 'decimal' | 'thousands'}} [given] a unit where none stands behind the number; the meaning of commas
 * @returns {Reading}
 */
export function readQuantity(text, quantity, units, { unit = '', meaning } = {}) {
  if (text.length > LONGEST) return readNumber(text);
  const { digits, name } = parted(text);
  // Neither is the x of 0x10 a unit.
  if (/^x\d/i.test(name)) return readNumber(text);
  if (!(name || unit) || !quantity) return readNumber(text, meaning);
  const reading = readNumber(digits, meaning);
  if ('problem' in reading) return reading;
  const value = inJobUnits(reading.value, name || unit, quantity, units);
  return value === undefined ? { problem: `${quoted(name || unit)} is no unit known here for this figure` } : { value };
}

/**
 * A figure of what is shown, in the units of the job: with a unit of its own behind it, or else in those that are shown.
 * @param {string} text
 * @param {Quantity} quantity
 * @param {Units} units of the job
 * @param {number} times from these to the units shown
 * @returns {Reading}
 */
export function readShown(text, quantity, units, times) {
  if (parted(text).name) return readQuantity(text, quantity, units);
  const reading = readNumber(text);
  return 'problem' in reading ? reading : { value: reading.value / times };
}

/** A figure of a job that is one: what is typed and is no number stands in the job as text. @param {unknown} value @returns {number} */
export const numberOf = (value) => (typeof value === 'number' ? value : NaN);

/** Without the spaces that do not break, and the apostrophes, that group digits before the decimal sign. @param {string} text */
export const groupsJoined = (text) =>
  text.replace(/(?<![\d.,\u00a0\u2009\u202f'’])\d{1,3}(?:[\u00a0\u2009\u202f'’]\d{3})+(?!\d)/g, (number) =>
    number.replace(/\D/g, ''),
  );

/** A number whose digits are grouped by threes, before the decimal sign, behind it or on both sides. */
const GROUPED =
  /^[+-]?(?:\d{1,3}(?:[\s'’]\d{3})+|\d*)(?:[.,](?:\d{3}(?:[\s'’]\d{3})*(?:[\s'’]\d{1,3})?|\d*))?(?:e[+-]?\d+)?$/i;

/** Dashes that stand for a minus where a keyboard has none, or a program has put them: hyphens, short dashes, the sign itself. */
const MINUS = /[\u2010-\u2013\u2212\ufe63\uff0d]/g;

/** The same with plain minus signs. @param {string} text */
export const withMinus = (text) => text.replace(MINUS, '-');

/** Powers of ten as this page and people write them: 4.5·10⁸, 4.5×10^8, 10⁻⁵. */
const POWER = /(?:([\d.,])\s*[·⋅×*]\s*|(?<![\d.,]))10(?:\^([+-]?\d+)|([⁺⁻]?[⁰¹²³⁴⁵⁶⁷⁸⁹]+))/g;
const RAISED = '⁰¹²³⁴⁵⁶⁷⁸⁹';

/** The same with powers of ten as exponents. @param {string} text */
const withExponents = (text) =>
  withMinus(text).replace(POWER, (_, digit = '1', level, raised = '') => {
    const lowered = [...raised].map((sign) => (sign === '⁻' ? '-' : sign === '⁺' ? '' : RAISED.indexOf(sign))).join('');
    return `${digit}e${level ?? lowered}`;
  });

/** Without what groups digits, with a plain minus and an exponent for a power of ten. @param {string} text */
function tidy(text) {
  const plain = withExponents(text).trim();
  return GROUPED.test(plain) ? plain.replace(/[\s'’]/g, '') : plain;
}

/** Most letters of a text that are repeated in a message, and of one that may be a number. */
const [SAID, LONGEST] = [40, 200];

/** What was typed, for a message that is read. @param {string} text */
export function quoted(text) {
  const plain = text.trim();
  return `“${plain.length > SAID ? `${plain.slice(0, SAID)}…` : plain}”`;
}

/** @param {number} columns */
export const columnsInWords = (columns) => ['no', 'one', 'two', 'three'][columns] ?? String(columns);
